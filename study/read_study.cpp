// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/read_study.hpp"

#include <filesystem>
#include <string>
#include <unordered_set>
#include <vector>

#include "base/nearest_name.hpp"
#include "base/safe_file.hpp"
#include "scene/overrides.hpp"
#include "scene/read_scene.hpp"
#include "scene/value_check.hpp"
#include "study/points.hpp"
#include "study/read_plot.hpp"
#include "study/read_result.hpp"
#include "study/read_slurm.hpp"
#include "study/read_vary.hpp"
#include "study/toml_table.hpp"

namespace dmp::study {

namespace {

namespace fs = std::filesystem;

std::string study_file(const std::string& path) {
    std::error_code none;
    if (!fs::exists(path, none))
        throw InputError({path, 0, 0}, "there is no such file or folder",
                         "give a study file or a folder with a study.toml");
    if (!fs::is_directory(path, none)) return path;
    const fs::path file = fs::path(path) / "study.toml";
    if (!fs::exists(file, none))
        throw InputError({path, 0, 0}, "this folder has no study.toml", "give a study file, or the folder of one");
    return file.string();
}

/// "vein_valve_study" for vein_valve/study.toml, "soft" for soft.toml.
std::string name_of(const std::string& file) {
    const fs::path stem = fs::path(file).stem();
    if (stem != "study") return stem.string();
    const fs::path folder = fs::absolute(file).lexically_normal().parent_path().filename();
    return folder.empty() ? "study" : folder.string() + "_study";
}

void read_combination(const TomlTable& table, Study& study) {
    study.combine = table.read("combine", one_of<Combine>(), study.combine);
    if (*study.combine == Combine::latin_hypercube) {
        study.samples = table.need("samples", integer(between(1, most_runs)));
        study.seed = table.read("seed", integer(not_negative), study.seed);
        return;
    }
    for (const char* key : {"samples", "seed"})
        if (const TomlNode* given = table.find(key))
            throw InputError(given->key_location,
                             "'" + std::string(key) + "' does not apply to combine = \"" +
                                 std::string(to_string(*study.combine)) + "\"",
                             "remove it, or write combine = \"latin_hypercube\"");
}

void check_axes(const Study& study) {
    for (const Vary& vary : study.vary)
        if (vary.is_axis()) return;
    throw InputError({study.file, 0, 0}, "the study varies nothing",
                     "add [[vary]] with a key and its values, such as values = [\"0.1 mm\", \"0.2 mm\"]");
}

/// A value for all runs is not one of a key that varies.
void check_overrides(const Study& study) {
    for (const std::string& each : study.overrides) {
        const std::string key = key_of_override(each);
        for (const VariedKey& varied : study.keys())
            if (*varied.key == key)
                throw InputError({"--set " + each, 0, 0},
                                 "the study varies '" + key + "', at " + varied.key.location.text(),
                                 "choose runs with --only, or change its values in the study");
    }
}

/// Of each run: one that its key does not take is found here, not after hours.
void check_formulas(const Study& study, const Points& points) {
    struct Formula {
        std::size_t key;
        SourceLocation location;
        ValueCheck check;
        std::unordered_set<std::string> checked{};  ///< what it was worked out to before
    };
    constexpr std::size_t most_checked = 10'000;
    std::vector<Formula> formulas;
    std::size_t key = 0;
    for (const Vary& vary : study.vary) {
        if (!vary.is_axis() && vary.keys[0].is_of_scene)
            formulas.push_back({key, vary.formulas[0].location,
                                ValueCheck(study.scene, *vary.keys[0].key, vary.keys[0].key.location)});
        key += vary.keys.size();
    }
    if (formulas.empty()) return;
    for (std::size_t index = 0; index < points.size(); ++index) {
        try {
            const std::vector<VariedValue> values = points.values_at(index);
            for (Formula& each : formulas) {
                const std::string& value = values[each.key].toml;
                if (each.checked.contains(value)) continue;
                each.check(parse_toml_value(value, each.location));
                if (each.checked.size() == most_checked) each.checked.clear();
                each.checked.insert(value);
            }
        } catch (const InputError& error) {
            throw InputError(
                error.where(),
                "run " + std::to_string(index + 1) + " of " + std::to_string(points.size()) + ": " + error.problem(),
                error.what_to_do());
        }
    }
}

}  // namespace

std::string Result::column_name() const { return column->empty() ? *measure : *measure + "_" + *column; }

std::vector<VariedKey> Study::keys() const {
    std::vector<VariedKey> all;
    for (const Vary& each : vary) all.insert(all.end(), each.keys.begin(), each.keys.end());
    return all;
}

Study read_study(const std::string& path, const std::vector<std::string>& overrides) {
    const std::string file = study_file(path);
    return parse_study(read_file(file), file, overrides);
}

Study parse_study(const std::string& text, const std::string& file, const std::vector<std::string>& overrides) {
    Study study;
    study.overrides = overrides;
    study.file = file;
    study.text = text;
    study.name = name_of(study.file);
    const TomlNode document = parse_toml(text, study.file);
    const TomlTable table(
        document, "",
        {"title", "purpose", "scene", "combine", "samples", "seed", "leave_out", "vary", "result", "plot", "slurm"});
    SourceLocation whole{study.file, 0, 0};
    if (table.find("scene") == nullptr)
        throw InputError(whole, "missing key: scene", "add 'scene': the scene's file, relative to the study's folder");
    study.scene_path = table.need("scene", text_not_empty());
    study.title = *table.read("title", text_not_empty(), Value<std::string>());
    study.purpose = *table.read("purpose", text_not_empty(), Value<std::string>());
    read_combination(table, study);
    study.slurm = read_slurm(document);
    if (const TomlNode* list = table.find("leave_out"))
        study.left_out = {read_left_out(*list, "leave_out"), list->location};

    const fs::path scene = (fs::path(study.file).parent_path() / *study.scene_path).lexically_normal();
    if (std::error_code none; !fs::exists(scene, none))
        throw InputError(study.scene_path.location, "scene: there is no '" + scene.string() + "'",
                         "give the scene's file, or its folder, relative to the folder of the study");
    study.scene = read_scene(scene.string(), overrides);
    for (const TomlNode* node : tables_of(document, "vary")) study.vary.push_back(read_vary(*node, study));
    check_axes(study);
    check_overrides(study);
    for (const TomlNode* node : tables_of(document, "result"))
        for (Result& result : read_results(*node, study)) study.results.push_back(std::move(result));
    const Points points(study);  // which refuses what does not go together
    check_formulas(study, points);
    study.plots = read_plots(document, study, points);
    return study;
}

}  // namespace dmp::study
