// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/study_options.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/text.hpp"
#include "scene/read_scene.hpp"
#include "scene/toml_node.hpp"
#include "solver/results/expected_steps.hpp"

namespace dmp::cli {

double time_of(const std::string& text, const char* option) {
    const SourceLocation location{option, 0, 0};
    const double time = read_quantity(text, "s", location);
    if (!(time > 0)) throw InputError(location, "'" + text + "' is no time above 0", "Give one such as \"20 min\".");
    return time;
}

double tolerance_of(const std::string& text) {
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    std::string_view unit(read.ptr, static_cast<std::size_t>(text.data() + text.size() - read.ptr));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    const double part = unit == "%" ? value / 100 : value;
    if (read.ec != std::errc() || (!unit.empty() && unit != "%") || !(part > 0 && part < 1))
        throw InputError({"--tolerance", 0, 0}, "'" + text + "' is no error above 0 and below 100 %",
                         "Give one such as \"5 %\", or 0.05.");
    return part;
}

std::vector<std::string> measures_to_add(const Scene& scene) {
    if (!scene.measures.empty()) return {};
    std::vector<std::string> measures{"kinetic_energy"};
    if (scene.species.size() == 1) measures.emplace_back("amount");
    return measures;
}

std::vector<std::string> overrides_that_add(const std::vector<std::string>& measures) {
    std::vector<std::string> overrides;
    for (const std::string& kind : measures) overrides.push_back("measure." + kind + ".kind=" + toml_quoted(kind));
    return overrides;
}

void need_two_rows(const Scene& scene, const std::string& until) {
    const double every = time_between_rows(scene);
    if (*scene.run.duration >= 2 * every) return;
    throw InputError({until.empty() ? scene.file : "--until", 0, 0},
                     fmt::format("runs to {} have fewer than two rows of measures, which are written every {}",
                                 duration_text(*scene.run.duration), duration_text(every)),
                     "Run longer, or set output.measure_every.");
}

}  // namespace dmp::cli
