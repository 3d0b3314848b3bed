// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/diagnosis.hpp"
#include "cli/exit_codes.hpp"
#include "cli/terminal.hpp"
#include "cli/workstation.hpp"

namespace dmp::cli {

namespace {

std::string mark(Health health, const Style& style) {
    switch (health) {
        case Health::ok:
            return style.good("ok  ");
        case Health::warn:
            return style.warning("warn");
        case Health::bad:
            return style.error("bad ");
    }
    return "";
}

}  // namespace

int execute(const DoctorCommand& /*command*/) {
    auto findings = diagnose(build_facts(), inspect_machine(std::filesystem::current_path()));
    if (const auto confinement = geometry_confinement()) findings.push_back(*confinement);
    const Style style(Stream::output);
    std::string text;
    for (const auto& finding : findings) {
        text += fmt::format("{}  {:<13} {}\n", mark(finding.health, style), finding.what, finding.found);
        if (!finding.to_do.empty()) text += fmt::format("{:21}{}\n", "", finding.to_do);
    }
    print(text);
    const bool bad = std::ranges::any_of(findings, [](const auto& finding) { return finding.health == Health::bad; });
    return bad ? exit_out_of_resource : exit_done;
}

}  // namespace dmp::cli
