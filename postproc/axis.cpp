// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/length_text.hpp"

namespace dmp::postproc {

namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, values...);
    return buffer.data();
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// The same format for all numbers of an axis: as many decimals as the step requires, and a power of ten where that
/// saves zeros.
std::string tick_text(double value, double step, double largest) {
    if (value == 0) return "0";
    const auto digits_to = [step](double power) {
        return std::max(0,
                        static_cast<int>(std::lround(power)) - static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    };
    if (largest < 1e5 && digits_to(0) <= 4) return format("%.*f", digits_to(0), value);
    const double power = std::floor(std::log10(largest) + 1e-9);
    return format("%.*fe%d", digits_to(power), value / std::pow(10.0, power), static_cast<int>(power));
}

}  // namespace

double round_below(double length) {
    if (!(length > 0) || !std::isfinite(length)) return 0;
    const double power = std::pow(10.0, std::floor(std::log10(length) + 1e-12));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= length * (1 + 1e-12)) return digit * power;
    return power;
}

Ticks round_ticks(double low, double high, int about) {
    Ticks ticks;
    const double wanted = (high - low) / std::max(about, 1);
    ticks.step = round_below(wanted * 1.5);
    if (ticks.step <= 0) return ticks;
    const double slack = 1e-9 * (high - low);
    for (double k = std::ceil((low - slack) / ticks.step); k * ticks.step <= high + slack; ++k)
        ticks.value.push_back(k * ticks.step);
    double largest = 0;
    for (const double value : ticks.value) largest = std::max(largest, std::abs(value));
    for (const double value : ticks.value) ticks.text.push_back(tick_text(value, ticks.step, largest));
    return ticks;
}

std::string printed_length(double length, double size) {
    std::string text = length_text(length, size);
    replace_all(text, "um", "µm");
    return text;
}

std::string printed_unit(const std::string& unit) {
    if (unit == "1") return {};
    std::string text = unit;
    replace_all(text, "^2", "²");
    replace_all(text, "^3", "³");
    replace_all(text, "*", "·");
    return text;
}

std::string axis_label(const std::string& name, const std::string& unit) {
    std::string text = name;
    std::replace(text.begin(), text.end(), '_', ' ');
    const std::string printed = printed_unit(unit);
    return printed.empty() ? text : text + " [" + printed + "]";
}

}  // namespace dmp::postproc
