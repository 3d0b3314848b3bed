// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/known_trade.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "base/shell_word.hpp"
#include "cli/output_folder.hpp"
#include "cli/scene_name.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/text.hpp"
#include "cli/trade/trade_outcome.hpp"
#include "report/json_value.hpp"
#include "scene/read_scene.hpp"
#include "study/front.hpp"
#include "study/time_series.hpp"
#include "study/trade_settings.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;
using report::JsonValue;

/// The trade.json of a scene; none where there is none.
std::optional<fs::path> trade_of_scene(const Scene& scene) {
    for (const fs::path& folder : {output_folder("", scene_name(scene) + "_trade"), fs::path(scene.directory)})
        if (const fs::path file = folder / trade_file_name; fs::is_regular_file(file)) return file;
    return {};
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

KnownSettings settings_in(const JsonValue& trade) {
    KnownSettings known;
    for (const JsonValue& setting : trade["settings"].elements()) {
        if (setting["is_repeat"].truth()) continue;
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

std::string percent(double part) { return number_text(100 * part, 2) + " %"; }

}  // namespace

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

KnownSetting known_setting(const SceneChoice& scene, const std::string& tolerance, const std::string& program) {
    const double largest = tolerance_of(tolerance);
    const auto file = trade_of_scene(read_scene(scene.path, scene.overrides));
    if (!file)
        throw InputError({"--tolerance", 0, 0}, "there is no trade of this scene", how_to_make_one(scene, program));
    const JsonValue::Json json = report::read_json_object(*file);
    const JsonValue trade(&json, *file);
    const SourceLocation where{file->string(), 0, 0};
    if (trade["identity"].text() != study::trade_identity({scene.path, scene.overrides}))
        throw InputError(where, "it is of another scene, or of this one with other values",
                         how_to_make_one(scene, program));
    const KnownSettings all = settings_in(trade);
    const auto index = study::cheapest_within(all.costs, largest);
    if (!index)
        throw InputError(where,
                         fmt::format("no setting has an error of at most {}: the best was {}", percent(largest),
                                     percent(smallest_error(all))),
                         "Choose a smaller particles.spacing and make a new trade, or take what can be reached.");
    const JsonValue& found = all.settings[*index];
    KnownSetting known{scene, "For an error of " + percent(largest) + ", by " + file->string() + ":"};
    for (const JsonValue& each : found["set"].elements()) {
        known.scene.overrides.push_back(each.text());
        known.text += " " + each.text();
    }
    const double part = trade["duration_s"].number() / trade["simulated_s"].number();
    known.text += fmt::format(" (error {}, about {} of one processor)\n", percent(found["error"].number()),
                              duration_text(found["processor_s"].number() * part));
    return known;
}

}  // namespace dmp::cli
