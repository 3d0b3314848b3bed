// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/chosen.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/prepare.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "scene/read_scene.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

namespace {

bool names_a_scene(const std::string& subject) {
    return std::filesystem::exists(subject) || subject.ends_with(".toml") || subject.find('/') != std::string::npos;
}

std::string models_text(const Plan& plan) {
    std::string text = Style(Stream::output).strong("Models") + "\n";
    for (const auto& use : plan.models) {
        text += "  " + use.model + "\n";
        if (!use.source.empty()) text += "      source  " + use.source + "\n";
        text += "      why     " + use.reason + "\n";
    }
    return text;
}

std::string warnings_text(const Plan& plan) {
    std::string text;
    for (const std::string& warning : plan.warnings)
        text += Style(Stream::output).warning("warning: ") + warning + "\n";
    return text.empty() ? text : text + "\n";
}

std::string memory_text(const Plan& plan) {
    std::size_t total = 0;
    for (const auto& [kind, count] : plan.particles) total += count;
    std::string fields;
    for (const auto& field : plan.fields) fields += "  " + field + "\n";
    return Style(Stream::output).strong("Fields of a particle") + "\n" + fields +
           fmt::format("  {} a particle, {} for {}\n", bytes_text(static_cast<double>(plan.bytes_per_particle)),
                       bytes_text(static_cast<double>(plan.bytes_per_particle * total)), count_text(total, "particle"));
}

}  // namespace

int execute(const ExplainCommand& command) {
    refuse_several_ranks();
    const auto& subject = command.subject;
    if (!names_a_scene(subject.path)) {
        if (!subject.overrides.empty()) {
            throw InputError("--set needs a scene, and '" + subject.path + "' is a key",
                             "Give a scene file or folder, or leave --set out.");
        }
        print(explain_key(subject.path));
        return exit_done;
    }
    const Prepared prepared = prepare(subject);
    const std::string head = heading(prepared);
    const int threads = threads_for(prepared.scene, command.threads);
    const Simulation simulation(prepared.scene, prepared.particles, threads);
    const Plan plan = simulation.plan();
    print(head + "\n" + chosen_text(prepared.scene, plan, prepared.origin) + "\n" + models_text(plan) + "\n" +
          warnings_text(plan) + limits_text(plan) + "\n" + memory_text(plan));
    return exit_done;
}

}  // namespace dmp::cli
