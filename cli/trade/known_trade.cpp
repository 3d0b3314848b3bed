// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/known_trade.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/shell_word.hpp"
#include "cli/output_folder.hpp"
#include "cli/scene_name.hpp"
#include "cli/sweep/study_options.hpp"
#include "cli/text.hpp"
#include "cli/trade/trade_outcome.hpp"
#include "cli/version.hpp"
#include "report/json_value.hpp"
#include "report/trade_facts.hpp"
#include "scene/read_scene.hpp"
#include "study/front.hpp"
#include "study/time_series.hpp"
#include "study/trade_settings.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;
using report::JsonValue;

/// Where a trade of a scene may lie.
std::vector<fs::path> trades_of_scene(const Scene& scene, const std::string& folder) {
    if (!folder.empty()) return {fs::path(folder) / trade_file_name};
    std::vector<fs::path> files{default_trade_folder(scene) / trade_file_name,
                                fs::path(scene.directory) / trade_file_name};
    std::erase_if(files, [](const fs::path& file) { return !fs::is_regular_file(file); });
    return files;
}

std::string how_to_make_one(const SceneChoice& scene, const std::string& program) {
    std::string line = program + " trade " + shell_word(scene.path);
    for (const std::string& each : scene.overrides) line += " --set " + shell_word(each);
    return "Measure what its settings cost and how wrong they are:\n  " + line;
}

/// The settings that may be taken, and what they cost.
struct KnownSettings {
    std::vector<JsonValue> settings;
    std::vector<study::CostAndError> costs;
};

/// Of those that no other beats, which leaves out what may not be taken.
KnownSettings settings_in(const JsonValue& trade) {
    KnownSettings known;
    const std::vector<JsonValue> front = trade["front"].elements();
    for (const JsonValue& setting : trade["settings"].elements()) {
        const std::string run = setting["run"].text();
        if (std::ranges::none_of(front, [&](const JsonValue& each) { return each.text() == run; })) continue;
        known.settings.push_back(setting);
        known.costs.push_back({setting["processor_s"].number(), setting["error"].number()});
    }
    return known;
}

double smallest_error(const KnownSettings& known) {
    double best = study::no_number;
    for (const study::CostAndError& each : known.costs) best = std::fmin(best, each.error);
    return best;
}

/// The first file that is a trade of this scene. Throws InputError where none is; of the first one, then.
nlohmann::ordered_json fitting_trade(const std::vector<fs::path>& files, const SceneChoice& scene,
                                     const std::string& program, fs::path& found) {
    if (files.empty())
        throw InputError({"--tolerance", 0, 0}, "there is no trade of this scene", how_to_make_one(scene, program));
    const std::string identity = study::trade_identity({scene.path, scene.overrides});
    for (const fs::path& file : files) {
        nlohmann::ordered_json json = report::read_json_object(file);
        if (JsonValue(&json, file)["identity"].text() != identity) continue;
        found = file;
        return json;
    }
    throw InputError({files.front().string(), 0, 0}, "it is of another scene, or of this one with other values",
                     how_to_make_one(scene, program));
}

/// Where another version has made it, whose costs and errors may be others.
std::string version_text(const JsonValue& trade) {
    const std::string made_by = trade["version"].text();
    return made_by == build_facts().version ? "" : "The trade was made by dmp " + made_by + ".\n";
}

}  // namespace

KnownSetting known_setting(const SceneChoice& scene, const std::string& tolerance, const std::string& folder,
                           const std::string& program) {
    const double largest = tolerance_of(tolerance);
    fs::path file;
    const Scene read = read_scene(scene.path, scene.overrides);
    const JsonValue::Json json = fitting_trade(trades_of_scene(read, folder), scene, program, file);
    const JsonValue trade(&json, file);
    if (*read.run.duration > trade["duration_s"].number() * (1 + 1e-9))
        throw InputError({file.string(), 0, 0},
                         fmt::format("it is of runs to {}, but the scene goes on to {}",
                                     duration_text(trade["duration_s"].number()), duration_text(*read.run.duration)),
                         how_to_make_one(scene, program));
    const KnownSettings all = settings_in(trade);
    const auto index = study::cheapest_within(all.costs, largest);
    if (!index)
        throw InputError({file.string(), 0, 0},
                         fmt::format("no setting has an error of at most {}: the best was {}", part_text(largest),
                                     part_text(smallest_error(all))),
                         "Choose a smaller particles.spacing and make a new trade, or take what can be reached.");
    const JsonValue& found = all.settings[*index];
    KnownSetting known{scene, "For an error of " + part_text(largest) + ", by " + file.string() + ":"};
    for (const JsonValue& each : found["set"].elements()) {
        known.scene.overrides.push_back(each.text());
        known.text += " " + each.text();
    }
    const double until = trade["simulated_s"].number(), duration = trade["duration_s"].number();
    known.text += fmt::format(" (error {}{}, about {} of one processor)\n", part_text(found["error"].number()),
                              compared_time_text(until, duration),
                              duration_text(found["processor_s"].number() * duration / until)) +
                  version_text(trade);
    return known;
}

}  // namespace dmp::cli
