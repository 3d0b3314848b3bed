// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "scene/quantity.hpp"
#include "scene/scene.hpp"
#include "scene/value.hpp"
#include "study/plot.hpp"
#include "study/run_output.hpp"
#include "study/slurm.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// How the values of several keys make runs: each with each, the first ones together, the second ones, ..., or samples
/// that cover the range of each key evenly (McKay, Beckman & Conover 1979).
enum class Combine { grid, zip, latin_hypercube };
enum class Scale { linear, log };
/// How a measure's values over time become one number (reduce.hpp).
enum class Reduction {
    mean,
    maximum,
    minimum,
    last,
    integral,
    slope,
    first_crossing,
    amplitude,
    phase,
    positive_integral,
    negative_integral
};

/// One value of a key that varies.
struct VariedValue {
    std::string toml;                  ///< as --set takes it: "\"0.8 mm\"", "3", "\"hexagonal\""
    std::string cell;                  ///< as results.csv has it: a number in the key's unit, else its text
    std::optional<Quantity> quantity;  ///< none of a name, a list, true or false
};

/// A key that varies.
struct VariedKey {
    Value<std::string> key;   ///< as for --set: "part.leaflets.bending_stiffness"
    std::string unit;         ///< of the numbers in results.csv, as the study writes it; "" where they have none
    bool is_of_scene = true;  ///< false: a name of the study's own, for formulas
};

/// Numbers between two ends, in the key's unit.
struct NumberRange {
    double from = 0, to = 0;
    Scale scale = Scale::linear;
    bool quoted = false;  ///< the key takes a text: a number and its unit
};

/// [[vary]]: a key and its values, or the keys of a table, which vary together.
struct Vary {
    SourceLocation location;
    std::vector<VariedKey> keys;
    std::vector<std::vector<VariedValue>> rows;  ///< what the keys take together, one for each key
    std::optional<NumberRange> range;            ///< of a Latin hypercube, which has no rows for it
    std::vector<WrittenText> formulas;           ///< in place of rows: of keys above it
    bool log_range = false;                      ///< the rows are a range of equal ratios
    bool is_list = false;                        ///< of formulas: the key takes a list of as many values

    /// Whether it makes runs of its own; a formula follows those of others.
    [[nodiscard]] bool is_axis() const { return formulas.empty(); }
};

/// [[result]]: a measure of the scene, reduced over time to one number of each run.
struct Result {
    Value<std::string> name;
    Value<std::string> measure;
    Value<std::string> column;  ///< which of the measure's columns, "low" of density_low; "": it has one
    Value<Reduction> reduce;
    Value<double> from = 0.0;  ///< [s]
    Value<double> until;       ///< [s]; not given: the run's end
    Value<Quantity> level;     ///< first_crossing: in the measure's unit
    Value<double> period;      ///< amplitude, phase: [s]

    /// Its column of measures.csv.
    [[nodiscard]] std::string column_name() const;
};

/// A study: one scene, the keys that vary, and what is kept of each run.
struct Study {
    std::string file;     ///< path of the study as given
    std::string text;     ///< what is in it
    std::string name;     ///< of its folder for study.toml, else of the file
    std::string title;    ///< of its page; "": its name
    std::string purpose;  ///< what it is to find out, for its page
    Value<std::string> scene_path;
    Scene scene;                         ///< without any of the values that vary
    std::vector<std::string> overrides;  ///< of the scene in all runs, as --set takes them
    Value<Combine> combine = Combine::grid;
    Value<int> samples;  ///< of a Latin hypercube
    Value<int> seed = 1;
    std::vector<Vary> vary;
    std::vector<Result> results;
    Slurm slurm;
    std::vector<Plot> plots;  ///< none: default_plots
    Value<LeftOut> left_out;  ///< by each run; not given: by the number of runs, left_out_of

    /// All that varies, in the order of the file.
    [[nodiscard]] std::vector<VariedKey> keys() const;
};

}  // namespace dmp::study

namespace dmp {

template <>
inline constexpr auto enum_names<study::Combine> = std::to_array<std::string_view>({"grid", "zip", "latin_hypercube"});
template <>
inline constexpr auto enum_names<study::Scale> = std::to_array<std::string_view>({"linear", "log"});
template <>
inline constexpr auto enum_names<study::Reduction> =
    std::to_array<std::string_view>({"mean", "maximum", "minimum", "last", "integral", "slope", "first_crossing",
                                     "amplitude", "phase", "positive_integral", "negative_integral"});

}  // namespace dmp
