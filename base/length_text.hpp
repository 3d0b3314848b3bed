// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/vec.hpp"

namespace dmp {

/// A unit of length.
struct LengthUnit {
    double metres = 1;
    const char* name = "m";
};

/// The unit in which lengths of about this size [m] read well: nm below 0.1 um, um below 0.1 mm, mm below 1 m.
LengthUnit length_unit(double size);

/// A length [m] for a person, four digits: "0.2 mm", "4 um", "1.5 m".
std::string length_text(double length);
/// A length [m] among others of about this size [m], in their unit; below a millionth of it: 0.
std::string length_text(double length, double size);

/// A place [m] for a person, five digits: "(0.5, 0, -3.25) mm"; of a geometry in 2-D "(0.5, 0) mm".
std::string position_text(const Vec& position, int dimension = 3);

/// How large a box is: "40 x 8 x 8 mm", "40 x 8 mm".
std::string extent_text(const Box& box, int dimension = 3);

}  // namespace dmp
