// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade_settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "base/hex_text.hpp"
#include "base/number_text.hpp"
#include "base/text_hash.hpp"
#include "base/unlisted_value.hpp"
#include "scene/read_scene.hpp"
#include "scene/toml_node.hpp"
#include "study/input_files.hpp"
#include "study/measure_columns.hpp"
#include "study/written_study.hpp"

namespace dmp::study {

namespace {

namespace fs = std::filesystem;

constexpr std::array factors{2.0, std::numbers::sqrt2, 1.0, 1 / std::numbers::sqrt2};
/// Repeats: the lattice lies otherwise in the walls, and the steps are shorter, by less than either matters.
constexpr std::array repeat_spacings{0.995, 1.005}, repeat_steps{0.97, 0.94};
constexpr const char* spacing_key = "particles.spacing";
constexpr const char* quality_key = "quality";
constexpr const char* sound_key = "numerics.sound_speed";
constexpr const char* step_key = "numerics.step_factor";

/// Of a speed of sound that the scene gives; down to this Mach number of the largest speed that it expects.
constexpr std::array sound_factors{1.0, 0.5, 0.25};
constexpr double largest_mach = 0.15;

/// "0.1414 mm"
std::string length_text(double length, int digits) {
    constexpr std::array units{std::pair{1.0, "m"}, std::pair{1e-3, "mm"}, std::pair{1e-6, "um"},
                               std::pair{1e-9, "nm"}};
    const auto* unit = std::ranges::find_if(units, [&](const auto& each) { return length >= 0.01 * each.first; });
    if (unit == units.end()) --unit;
    return number_text(length / unit->first, digits) + " " + unit->second;
}

Scene with(const TradeScene& scene, const std::vector<std::string>& more) {
    std::vector<std::string> all = scene.overrides;
    all.insert(all.end(), more.begin(), more.end());
    return read_scene(scene.path, all);
}

std::string assignment(const std::string& key, const std::string& toml) { return key + "=" + toml; }

/// All that a scene's runs depend on, without what does not act in it.
std::string what_acts(Scene scene) {
    scene.quality = Quality::standard;
    const Scene defaults;
    if (scene.parts_of(PartKind::spheres).empty())
        scene.numerics.steps_per_contact = defaults.numerics.steps_per_contact;
    return resolved_scene(scene);
}

/// The levels that make different runs of the scene, with their scenes: not those of a scene that gives all that they
/// set.
std::map<Quality, Scene> different_levels(const TradeScene& scene) {
    std::map<Quality, Scene> different;
    std::set<std::string> seen;
    for (const Quality quality : {Quality::standard, Quality::draft, Quality::fine}) {
        Scene at_level = with(scene, {assignment(quality_key, toml_quoted(to_string(quality)))});
        if (seen.insert(what_acts(at_level)).second) different.emplace(quality, std::move(at_level));
    }
    return different;
}

double rank_of(Quality quality) {
    switch (quality) {
        case Quality::draft:
            return 0;
        case Quality::standard:
            return 1;
        case Quality::fine:
            return 2;
    }
    unlisted_value(quality);
}

TradeLevel level_of_quality(Quality quality) { return {to_string(quality), rank_of(quality)}; }

/// "auto" may be written down, too.
bool gives_sound_speed(const Scene& scene) { return *scene.numerics.sound_speed > 0; }

std::string speed_text(double speed) { return number_text(speed, 6) + " m/s"; }

TradeLevel level_of_sound(double speed) { return {"sound speed " + speed_text(speed), speed}; }

/// A level, and how it is set.
struct LevelOfScene {
    TradeLevel level;
    std::string toml;        ///< of the key that sets it
    double steps = 1;        ///< in the same time, as a multiple
    double step_factor = 0;  ///< numerics.step_factor
};

std::vector<LevelOfScene> levels_of_quality(const TradeScene& scene) {
    std::vector<LevelOfScene> levels;
    for (const auto& [quality, at_level] : different_levels(scene))
        // Steps are by the speed of sound and that of the flow.
        levels.push_back({level_of_quality(quality), toml_quoted(to_string(quality)),
                          1 + 1 / *at_level.numerics.mach_number, *at_level.numerics.step_factor});
    return levels;
}

std::vector<LevelOfScene> levels_of_sound(const Scene& scene) {
    std::vector<LevelOfScene> levels;
    const double given = *scene.numerics.sound_speed;
    for (const double factor : sound_factors) {
        const double speed = given * factor;
        if (factor < 1 && !(scene.flow.largest_speed.given() && *scene.flow.largest_speed <= largest_mach * speed))
            continue;
        levels.push_back({level_of_sound(speed), toml_quoted(speed_text(speed)), factor, *scene.numerics.step_factor});
    }
    return levels;
}

/// Columns of settings: what each of the trade's keys is set to.
class Rows {
  public:
    explicit Rows(const TradeScene& scene) : own_(with(scene, {})) {
        const bool gives_sound = gives_sound_speed(own_);
        levels_ = gives_sound ? levels_of_sound(own_) : levels_of_quality(scene);
        const std::string own_text = level_of(own_, own_).text;
        const auto own = std::ranges::find(levels_, own_text, [](const auto& each) { return each.level.text; });
        own_level_ = own == levels_.end() ? 0 : static_cast<std::size_t>(own - levels_.begin());  // which is the same
        has_spacing_ = own_.particles.spacing.given();
        has_steps_ = own_.flow.largest_speed.given() && has_spacing_;
        if (has_spacing_) result_.keys.emplace_back(spacing_key);
        result_.keys.emplace_back(gives_sound ? sound_key : quality_key);
        if (has_steps_) result_.keys.emplace_back(step_key);
    }

    TradeSettings settings() {
        if (has_spacing_) {
            for (const double factor : factors)
                for (const LevelOfScene& level : levels_) add(factor, level, 1);
            for (std::size_t k = 0; k < repeat_spacings.size(); ++k) {
                add(repeat_spacings[k], levels_[own_level_], has_steps_ ? repeat_steps[k] : 1);
                result_.settings.back().role = TradeRole::repeat;
            }
        } else {
            for (const LevelOfScene& level : levels_) add(1, level, 1);
        }
        result_.own_level = levels_[own_level_].level;
        std::ranges::stable_sort(result_.settings, {}, &TradeSetting::cost);
        return std::move(result_);
    }

  private:
    void add(double factor, const LevelOfScene& level, double step) {
        TradeSetting setting;
        setting.level = level.level;
        if (has_spacing_) {
            setting.spacing_text = length_text(*own_.particles.spacing * factor, factor == 1 ? 15 : 4);
            setting.spacing = read_quantity(setting.spacing_text, "m");
            setting.values.push_back(toml_quoted(setting.spacing_text));
        }
        setting.values.push_back(level.toml);
        if (has_steps_) setting.values.push_back(number_text(level.step_factor * step, 6));
        setting.cost = level.steps / levels_[own_level_].steps / std::pow(factor, *own_.dimension + 1) / step;
        result_.settings.push_back(std::move(setting));
    }

    Scene own_;
    std::vector<LevelOfScene> levels_;
    std::size_t own_level_ = 0;
    bool has_spacing_ = false, has_steps_ = false;
    TradeSettings result_;
};

}  // namespace

bool TradeSettings::sets(const std::string& assignment) const {
    return std::ranges::find(keys, key_set_by(assignment)) != keys.end();
}

std::vector<double> TradeSettings::costs() const {
    std::vector<double> costs;
    for (const TradeSetting& setting : settings) costs.push_back(setting.cost / settings.front().cost);
    return costs;
}

std::vector<std::string> TradeSettings::overrides(const TradeSetting& setting) const {
    std::vector<std::string> all;
    if (setting.role == TradeRole::reference) return all;
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (keys[k] != step_key || setting.role == TradeRole::repeat)
            all.push_back(assignment(keys[k], setting.values[k]));
    return all;
}

std::string spacing_text(double length) { return length_text(length, 4); }

TradeLevel level_of(const Scene& as_run, const Scene& scene) {
    return gives_sound_speed(scene) ? level_of_sound(*as_run.numerics.sound_speed) : level_of_quality(*as_run.quality);
}

TradeSettings trade_settings(const TradeScene& scene) { return Rows(scene).settings(); }

std::string trade_identity(const TradeScene& scene) {
    Scene read = with(scene, {assignment(quality_key, toml_quoted(to_string(Quality::standard)))});
    const Scene defaults;
    // What the settings set: whether it is given matters, not its value.
    if (read.particles.spacing.given()) read.particles.spacing = 1;
    if (gives_sound_speed(read)) read.numerics.sound_speed = 1;
    read.title = defaults.title;
    read.run.duration = 1;
    read.run.threads = defaults.run.threads;
    read.output = defaults.output;
    std::string all = resolved_scene(read);
    Study study;
    study.scene = std::move(read);
    for (const InputFile& file : input_files(study)) all += file.name + " " + file.hash + "\n";
    return hex_text(text_hash(all));
}

std::string trade_study(const TradeScene& scene, const TradeSettings& settings, const fs::path& folder) {
    const Scene read = with(scene, {});
    WrittenStudy study;
    study.comment = "Written by 'dmp trade': settings of the scene whose costs and errors it compares, cheapest first.";
    study.title = "Cost and error: " + (read.title->empty() ? scene.path : *read.title);
    study.purpose =
        "What the settings of the scene cost, and how far their results lie apart; trade.json has the errors.";
    study.scene = scene.path;
    for (std::size_t k = 0; k < settings.keys.size(); ++k) {
        std::vector<std::string>& values =
            study.columns.emplace_back(settings.keys[k], std::vector<std::string>()).second;
        for (const TradeSetting& setting : settings.settings) values.push_back(setting.values[k]);
    }
    std::map<std::string, std::string> common = values_set(scene.overrides);
    for (const std::string& key : settings.keys) common.erase(key);
    for (const auto& [key, value] : common)
        study.columns.emplace_back(key, std::vector(settings.settings.size(), value));
    std::string text = study_text(study, folder);
    // For the page's plots: numbers by which people see the runs converge.
    for (const Measure& measure : read_scene(scene.path).measures) {
        if (columns_of(*measure.kind).count != MeasureColumns::Count::one) continue;
        for (const char* reduction : {"mean", "maximum"})
            text += fmt::format("\n[[result]]\nname = {}\nmeasure = {}\nreduce = \"{}\"\n",
                                toml_quoted(*measure.name + "_" + reduction), toml_quoted(*measure.name), reduction);
    }
    return text;
}

}  // namespace dmp::study
