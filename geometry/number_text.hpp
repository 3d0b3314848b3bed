// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>

#include "base/vec.hpp"

namespace dmp {

/// A number for a person, with six digits at most.
inline std::string number_text(double number) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << number;
    return text.str();
}

/// A place in space for a person: "(1 m, 0.5 m, 0 m)".
inline std::string text_in_space(const Vec& point) {
    return "(" + number_text(point.x()) + " m, " + number_text(point.y()) + " m, " + number_text(point.z()) + " m)";
}

}  // namespace dmp
