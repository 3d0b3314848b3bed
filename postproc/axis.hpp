// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace dmp::postproc {

/// Round numbers (1, 2 or 5 times a power of ten apart) in [low, high], about `about` of them, and their texts.
struct Ticks {
    std::vector<double> value;
    std::vector<std::string> text;
    double step = 0;
};
Ticks round_ticks(double low, double high, int about);

/// The largest of 1, 2, 5 times a power of ten that is not above `length`; 0 unless length > 0 and finite.
double round_below(double length);

/// A length [m] among others of about `size` [m], in their unit: -0.0025 among 0.01 -> "-2.5 mm".
std::string printed_length(double length, double size);

/// "m^2/s" -> "m²/s"; "1" and "" -> "".
std::string printed_unit(const std::string& unit);

/// "inlet_flux", "m^2/s" -> "inlet flux [m²/s]".
std::string axis_label(const std::string& name, const std::string& unit);

}  // namespace dmp::postproc
