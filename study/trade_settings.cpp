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

namespace dmp::study {

namespace {

namespace fs = std::filesystem;

constexpr std::array factors{2.0, std::numbers::sqrt2, 1.0, 1 / std::numbers::sqrt2};
/// Repeats: the lattice lies otherwise in the walls, and the steps are shorter, by less than either matters.
constexpr std::array repeat_spacings{0.995, 1.005}, repeat_steps{0.97, 0.94};
constexpr const char* spacing_key = "particles.spacing";
constexpr const char* quality_key = "quality";
constexpr const char* step_key = "numerics.step_factor";

/// Steps of the corrected scheme go so.
double steps_of(Quality quality) {
    switch (quality) {
        case Quality::draft:
            return 2.0 / 3;
        case Quality::standard:
            return 1;
        case Quality::fine:
            return 2;
    }
    unlisted_value(quality);
}

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
    if (scene.numerics.sound_speed.given()) scene.numerics.mach_number = defaults.numerics.mach_number;
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

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// What is set in all runs, besides what the settings set, as TOML; of a key that is given twice the last one. Threads
/// are not a run's own.
std::map<std::string, std::string> common_values(const TradeScene& scene, const TradeSettings& settings) {
    std::map<std::string, std::string> values;
    for (const std::string& each : scene.overrides) {
        const auto equals = each.find('=');
        const std::string key = trimmed(each.substr(0, equals));
        if (key == "run.threads" || std::ranges::find(settings.keys, key) != settings.keys.end()) continue;
        values[key] = toml_text(parse_toml_value(each.substr(equals + 1), {}));
    }
    return values;
}

/// Columns of settings: what each of the trade's keys is set to.
class Rows {
  public:
    explicit Rows(const TradeScene& scene)
        : levels_(different_levels(scene)),
          own_(levels_.at(Quality::standard)),
          own_quality_(*with(scene, {}).quality) {
        if (!levels_.contains(own_quality_)) own_quality_ = Quality::standard;  // which is the same
        has_spacing_ = own_.particles.spacing.given();
        has_steps_ = own_.flow.largest_speed.given() && has_spacing_;
        if (has_spacing_) result_.keys.emplace_back(spacing_key);
        result_.keys.emplace_back(quality_key);
        if (has_steps_) result_.keys.emplace_back(step_key);
    }

    TradeSettings settings() {
        if (has_spacing_) {
            for (const double factor : factors)
                for (const auto& [quality, at_level] : levels_) add(factor, quality, 1);
            for (std::size_t k = 0; k < repeat_spacings.size(); ++k) {
                add(repeat_spacings[k], own_quality_, has_steps_ ? repeat_steps[k] : 1);
                result_.settings.back().role = TradeRole::repeat;
            }
        } else {
            for (const auto& [quality, at_level] : levels_) add(1, quality, 1);
        }
        std::ranges::stable_sort(result_.settings, {}, &TradeSetting::cost);
        return std::move(result_);
    }

  private:
    void add(double factor, Quality quality, double step) {
        TradeSetting setting;
        setting.quality = quality;
        if (has_spacing_) {
            setting.spacing_text = length_text(*own_.particles.spacing * factor, factor == 1 ? 15 : 4);
            setting.spacing = read_quantity(setting.spacing_text, "m");
            setting.values.push_back(toml_quoted(setting.spacing_text));
        }
        setting.values.push_back(toml_quoted(to_string(quality)));
        if (has_steps_) setting.values.push_back(number_text(*levels_.at(quality).numerics.step_factor * step, 6));
        setting.cost = steps_of(quality) / std::pow(factor, *own_.dimension + 1) / step;
        result_.settings.push_back(std::move(setting));
    }

    std::map<Quality, Scene> levels_;
    const Scene& own_;
    Quality own_quality_;
    bool has_spacing_ = false, has_steps_ = false;
    TradeSettings result_;
};

}  // namespace

std::vector<std::string> TradeSettings::overrides(const TradeSetting& setting) const {
    std::vector<std::string> all;
    if (setting.role == TradeRole::reference) return all;
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (keys[k] != step_key || setting.role == TradeRole::repeat)
            all.push_back(assignment(keys[k], setting.values[k]));
    return all;
}

std::string spacing_text(double length) { return length_text(length, 4); }

TradeSettings trade_settings(const TradeScene& scene) { return Rows(scene).settings(); }

std::string trade_identity(const TradeScene& scene) {
    Scene read = with(scene, {assignment(quality_key, toml_quoted(to_string(Quality::standard)))});
    const Scene defaults;
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
    const std::size_t runs = settings.settings.size();
    std::string text =
        "# Written by 'dmp trade': settings of the scene whose costs and errors it compares, cheapest first.\ntitle "
        "= " +
        toml_quoted("Cost and error: " + (read.title->empty() ? scene.path : *read.title)) +
        "\npurpose = \"What the settings of the scene cost, and how far their results lie apart; trade.json has the "
        "errors.\"\nscene = " +
        toml_quoted(fs::absolute(scene.path)
                        .lexically_normal()
                        .lexically_proximate(fs::absolute(folder).lexically_normal())
                        .string()) +
        "\ncombine = \"zip\"\nleave_out = [\"frames\", \"pictures\", \"page\"]\n";
    const auto vary = [&](const std::string& key, const std::vector<std::string>& values) {
        text += "\n[[vary]]\nkey = " + toml_quoted(key) + fmt::format("\nvalues = [{}]\n", fmt::join(values, ", "));
    };
    for (std::size_t k = 0; k < settings.keys.size(); ++k) {
        std::vector<std::string> values;
        for (const TradeSetting& setting : settings.settings) values.push_back(setting.values[k]);
        vary(settings.keys[k], values);
    }
    for (const auto& [key, value] : common_values(scene, settings)) vary(key, std::vector(runs, value));
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
