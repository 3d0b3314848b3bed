// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dmp::report {

/// What the page of a study says of it beside its results; written beside them (study.json), so that the page can be
/// made of the study's folder alone.
struct StudyFacts {
    struct Key {
        std::string name, unit;
        std::string values;       ///< what it takes, in words: "5 values from 1e-06 to 1e-05, of equal ratios"
        bool is_formula = false;  ///< it follows other keys
    };
    struct Result {
        std::string name;
        std::string meaning;  ///< "the maximum of tip_gap from 1 s on"
    };
    /// Points of another origin.
    struct Reference {
        std::string file;
        std::vector<double> x;  ///< in the unit of the plot's key
        std::vector<double> y;  ///< in SI units
        std::string problem;    ///< why they are not shown; "": they are
    };
    struct Plot {
        std::string title;  ///< may be ""
        std::string result, key;
        std::string lines_by;  ///< a key; "": one line
        bool log_x = false, log_y = false;
        std::vector<Reference> references;  ///< none or one
    };
    std::string title, purpose;  ///< purpose: may be ""
    std::string study_file, scene_file, scene_title;
    std::string combination;    ///< how the keys go together, in words
    bool is_scattered = false;  ///< no two runs differ in one key alone: a Latin hypercube
    bool default_plots = false;
    std::size_t runs = 0;  ///< of the whole study
    std::vector<Key> keys;
    std::vector<Result> results;
    std::vector<Plot> plots;
};

inline constexpr const char* study_facts_name = "study.json";

/// folder/study.json. Throws ResourceError if it cannot be written.
void write_study_facts(const std::filesystem::path& folder, const StudyFacts& facts);

/// Throws InputError where the file is missing or damaged.
[[nodiscard]] StudyFacts read_study_facts(const std::filesystem::path& folder);

}  // namespace dmp::report
