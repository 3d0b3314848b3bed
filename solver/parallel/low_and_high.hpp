// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace dmp::solver {

/// The smallest and the largest value(i) for i in [0, count); infinity and -infinity if count is 0. Computed in
/// separate lanes, so that the compiler can vectorise: it may not itself reorder comparisons, because their order
/// matters for NaN.
template <class Value>
std::pair<double, double> low_and_high(std::ptrdiff_t count, int threads, const Value& value) {
    constexpr std::ptrdiff_t lanes = 8, block = 64 * lanes;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = infinity, high = -infinity;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : high) reduction(min : low)
    for (std::ptrdiff_t begin = 0; begin < count; begin += block) {
        const std::ptrdiff_t end = std::min(begin + block, count), end_of_lanes = begin + (end - begin) / lanes * lanes;
        std::array<double, lanes> lows, highs;
        lows.fill(infinity);
        highs.fill(-infinity);
        const auto update = [&](std::ptrdiff_t i, std::ptrdiff_t lane) {
            const double x = value(i);
            lows[lane] = x < lows[lane] ? x : lows[lane];
            highs[lane] = x > highs[lane] ? x : highs[lane];
        };
        for (std::ptrdiff_t i = begin; i < end_of_lanes; i += lanes)
            for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) update(i + lane, lane);
        for (std::ptrdiff_t i = end_of_lanes; i < end; ++i) update(i, 0);
        for (const double x : lows) low = std::min(low, x);
        for (const double x : highs) high = std::max(high, x);
    }
    return {low, high};
}

}  // namespace dmp::solver
