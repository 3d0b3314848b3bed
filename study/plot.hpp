// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "scene/quantity.hpp"
#include "scene/value.hpp"
#include "study/uses.hpp"

namespace dmp::study {

enum class PlotAxis { x, y };

/// Points of a CSV file that a plot shows beside the runs, one for each of its lines.
struct ReferencePoints {
    Value<std::string> file;  ///< as the study names it
    std::vector<double> x;    ///< in the unit of the plot's key
    std::vector<double> y;    ///< in SI units
    Dimension y_dimension;
};

/// [[plot]]: a result over a key.
struct Plot {
    SourceLocation location;
    std::string title;     ///< "": none of its own
    std::string result;    ///< name of a result
    std::string key;       ///< along x; it varies
    std::string lines_by;  ///< a line for each value of this key; "": one line
    bool log_x = false, log_y = false;
    std::optional<ReferencePoints> reference;
};

/// Lines of a plot that can be told apart.
inline constexpr std::size_t most_lines = 12;

}  // namespace dmp::study

namespace dmp {

template <>
inline constexpr auto enum_names<study::PlotAxis> = std::to_array<std::string_view>({"x", "y"});

}  // namespace dmp
