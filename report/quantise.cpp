// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/quantise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace dmp::report {

std::uint16_t step_of(double value, double low, double high) {
    if (!(value >= low && value <= high)) throw std::invalid_argument("step_of: a value outside its range");
    return high > low ? static_cast<std::uint16_t>(std::lround((value - low) / (high - low) * 65535)) : 0;
}

ColourRange colour_range(std::vector<float>& values, bool is_signed) {
    std::erase_if(values, [](float value) { return !std::isfinite(value); });
    if (values.empty()) return {};
    const auto smallest_but = [&](std::size_t n) {
        const auto nth = values.begin() + static_cast<std::ptrdiff_t>(n);
        std::ranges::nth_element(values, nth);
        return static_cast<double>(*nth);
    };
    const std::size_t outside = (values.size() - 1) / 100;
    ColourRange range{smallest_but(outside), smallest_but(values.size() - 1 - outside), false, true};
    range.diverging = is_signed || (range.low < 0 && range.high > 0);
    if (range.diverging) {
        range.high = std::max(std::abs(range.low), std::abs(range.high));
        range.low = -range.high;
    } else if (range.low > 0 && range.low < range.high / 3) {
        range.low = 0;
    } else if (range.high < 0 && range.high > range.low / 3) {
        range.high = 0;
    }
    return range;
}

std::uint8_t colour_of(double value, const ColourRange& range) {
    constexpr int last = colours_of_range - 1;
    if (std::isnan(value)) return colour_of_nan;
    if (range.high <= range.low)
        return static_cast<std::uint8_t>(value < range.low ? 0 : value > range.high ? last : last / 2);
    const double share = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(share * last));
}

void append(std::string& bytes, std::uint16_t number) {
    bytes += static_cast<char>(number & 0xFFU);
    bytes += static_cast<char>(number >> 8U);
}

void append(std::string& bytes, std::uint32_t number) {
    append(bytes, static_cast<std::uint16_t>(number & 0xFFFFU));
    append(bytes, static_cast<std::uint16_t>(number >> 16U));
}

}  // namespace dmp::report
