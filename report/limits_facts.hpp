// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"

namespace dmp::report {

/// The limits of a scene's models, and their picture (limits_picture.hpp), in their folder.
inline constexpr const char* limits_file_name = "limits.json";
inline constexpr const char* limits_picture_name = "limits.svg";

/// How the values of a dial end.
enum class LimitWay {
    not_measured,  ///< not yet: there was no time, or a run failed, other than by what it was given
    none_found,    ///< all values are clean
    departs,       ///< a measure is further from that of the scene's own settings than is allowed
    breaks,        ///< the simulation diverges
    refused,       ///< by the check of the scene or of its particles
    no_measure     ///< it is by measures that it would be seen, and none counts
};

/// What was found of where a scene's models end, as limits.json has it.
struct LimitsFacts {
    /// A value of a scene that was turned, up or down.
    struct Dial {
        std::string name;               ///< its first key: "part.blood.viscosity"
        std::vector<std::string> keys;  ///< all, which go by the same factor
        std::string what;
        bool is_up = true;
        bool is_physical = false;
        std::string unit;                  ///< SI; "": plain numbers
        double own = 0;                    ///< the scene's value
        std::optional<double> stated;      ///< limit that the program states
        std::string stated_by;             ///< a formula, or what the check says
        std::optional<double> clean, bad;  ///< last clean value, the scene's own at least, and first bad one
        std::string clean_run, bad_run;    ///< "": none was needed
        std::optional<double> bound;       ///< refused beyond, by the check of the scene: no value is bad
        LimitWay way = LimitWay::not_measured;
        std::string cause;  ///< what the first bad run said, or why there are no further values; or the failed one
        std::string likely_causes;     ///< that it named; "": none
        double distance = 0;           ///< of the measure that departs; NaN: none
        std::string column;            ///< that it is of
        std::vector<std::string> set;  ///< what --set takes for the last clean value

        /// Last clean value over the scene's own, or the inverse where it is below: how far it may go at least; none
        /// where the dial is not measured to its end.
        [[nodiscard]] std::optional<double> margin() const;
        /// Stated limit over the scene's own value, or the inverse, likewise.
        [[nodiscard]] std::optional<double> stated_margin() const;
    };
    /// A column of measures that runs were compared by.
    struct Column {
        std::string name;
        double scatter = 0;  ///< relative; NaN: not known
        double allowed = 0;  ///< relative distance from which on a run departs
        bool counts = true;
    };
    std::string scene;                    ///< its path, as given to dmp
    std::string name;                     ///< of the scene
    std::string version;                  ///< of the dmp that found them
    std::vector<std::string> set_in_all;  ///< what --set takes, of all runs
    double simulated = 0, duration = 0;   ///< of the runs, and of the scene [s]
    double tolerance = 0;
    std::string own_run;
    std::vector<Column> columns;
    std::vector<std::string> notes;  ///< what is to be known of the measures, such as that their scatter is not known
    std::vector<Dial> dials;
};

/// A value with its unit: "0.003 Pa*s"; "-" for none.
[[nodiscard]] std::string limit_value_text(const std::optional<double>& value, const std::string& unit);
/// "breaks", "departs: 12 % in energy", "not measured".
[[nodiscard]] std::string limit_way_text(const LimitsFacts::Dial& dial);
/// "2.4": how many times; "-" for none.
[[nodiscard]] std::string margin_text(const std::optional<double>& margin);

/// "0.7, 1.4 times": a stated limit with its margin.
[[nodiscard]] std::string stated_text(const std::string& stated, const std::optional<double>& margin);

/// Writes limits.json. Throws ResourceError.
void write_limits_facts(const std::filesystem::path& folder, const LimitsFacts& limits);
/// Throws InputError, which names the file and the place, where it cannot be read or is damaged.
[[nodiscard]] LimitsFacts read_limits_facts(const std::filesystem::path& file);

}  // namespace dmp::report

namespace dmp {

template <>
inline constexpr auto enum_names<report::LimitWay> =
    std::to_array<std::string_view>({"not_measured", "none_found", "departs", "breaks", "refused", "no_measure"});

}  // namespace dmp
