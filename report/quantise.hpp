// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dmp::report {

/// A value from low to high as a number of 16 bits, the nearest of 65536 even steps; 0 where low and high are the same.
/// Throws std::invalid_argument for a value outside.
[[nodiscard]] std::uint16_t step_of(double value, double low, double high);

/// The values that the colours of a field run over.
struct ColourRange {
    double low = 0, high = 0;
    bool diverging = false;  ///< even around 0
    bool any = false;        ///< false: there are no values
};

/// From the 1st to the 99th percentile of the finite values; from 0 where what is below is less than a third of the
/// range, and even around 0 where there are both signs or `is_signed`. `values` are put in another order.
[[nodiscard]] ColourRange colour_range(std::vector<float>& values, bool is_signed);

/// Colours of a range, and the number that stands for a value that is none.
inline constexpr int colours_of_range = 255;
inline constexpr std::uint8_t colour_of_nan = 255;

/// The nearest of the colours of a range, from 0; that of the end for values beyond it, colour_of_nan for NaN.
[[nodiscard]] std::uint8_t colour_of(double value, const ColourRange& range);

/// Adds a number, its low byte first.
void append(std::string& bytes, std::uint16_t number);
void append(std::string& bytes, std::uint32_t number);

}  // namespace dmp::report
