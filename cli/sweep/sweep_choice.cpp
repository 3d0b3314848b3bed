// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "scene/toml_node.hpp"
#include "scene/value_check.hpp"
#include "study/varied_value.hpp"

namespace dmp::cli {

namespace {

/// A value that a key is to have.
struct Wanted {
    std::size_t key;
    study::VariedValue value;

    [[nodiscard]] bool has(const study::Point& point) const {
        const study::VariedValue& other = point.values[key];
        if (!value.quantity || !other.quantity) return value.cell == other.cell;
        const double largest = std::max(std::abs(value.quantity->si), std::abs(other.quantity->si));
        return std::abs(value.quantity->si - other.quantity->si) <= 1e-12 * largest;
    }
};

Wanted wanted(const study::Study& study, const std::string& text) {
    const SourceLocation location{"--only " + text, 0, 0};
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw InputError(location, "expected KEY=VALUE", "Write for example --only particles.spacing=\"0.1 mm\".");
    const std::string key = text.substr(0, equals);
    const std::vector<study::VariedKey> keys = study.keys();
    std::vector<std::string> names;
    for (const study::VariedKey& each : keys) names.push_back(*each.key);
    const auto found = std::ranges::find(names, key);
    if (found == names.end()) {
        const std::string nearest = nearest_name(key, names);
        throw InputError(location, "the study does not vary '" + key + "'",
                         nearest.empty() ? "It varies " + quoted_list(names) + "." : "Did you mean '" + nearest + "'?");
    }
    const auto index = static_cast<std::size_t>(found - names.begin());
    const TomlNode value = parse_toml_value(text.substr(equals + 1), location);
    if (keys[index].is_of_scene) ValueCheck(study.scene, key, location)(value);
    std::string unit = keys[index].unit;
    return {index, study::varied_value(value, unit)};
}

}  // namespace

std::vector<std::size_t> chosen_runs(const study::Study& study, const study::Points& points,
                                     const std::vector<std::string>& only) {
    std::vector<std::size_t> chosen(points.size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    for (const std::string& text : only) {
        const Wanted value = wanted(study, text);
        std::erase_if(chosen, [&](std::size_t index) { return !value.has(points.at(index)); });
        if (chosen.empty())
            throw InputError({"--only " + text, 0, 0}, "no run of the study has this value",
                             "'dmp sweep STUDY --dry-run' lists the runs and their values.");
    }
    return chosen;
}

}  // namespace dmp::cli
