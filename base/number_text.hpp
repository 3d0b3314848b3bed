// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace dmp {

/// A number with at most this many significant digits: "0.25", "1.2e-06".
inline std::string number_text(double value, int digits = 6) {
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
}

/// A fraction in per cent, with two digits or all before the point: "0.43 %", "120 %".
inline std::string percentage_text(double fraction) {
    return (fraction < 0.995 ? number_text(100 * fraction, 2) : number_text(std::round(100 * fraction))) + " %";
}

}  // namespace dmp
