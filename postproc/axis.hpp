// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace dmp::postproc {

/// Round numbers in [low, high], spaced by 1, 2 or 5 times a power of ten, about `about` of them, and their texts.
struct Ticks {
    std::vector<double> value;
    std::vector<std::string> text;
    double step = 0;
};
Ticks round_ticks(double low, double high, int about);

/// The largest number not above `length` that is 1, 2 or 5 times a power of ten; 0 unless length > 0 and finite.
double round_below(double length);

/// A length [m] in the unit that suits `size` [m]: -0.0025 with size 0.01 -> "-2.5 mm".
std::string printed_length(double length, double size);

/// "m^2/s" -> "m²/s"; "1" and "" -> "".
std::string printed_unit(const std::string& unit);

/// "inlet_flux", "m^2/s" -> "inlet flux [m²/s]".
std::string axis_label(const std::string& name, const std::string& unit);

}  // namespace dmp::postproc
