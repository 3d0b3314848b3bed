// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace dmp
