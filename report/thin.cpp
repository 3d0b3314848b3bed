// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/thin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace dmp::report {

namespace {

/// Of the points from `begin` to `end`: where the extremes are and the first missing one, sorted.
std::vector<std::size_t> telling_points(const std::vector<double>& value, std::size_t begin, std::size_t end) {
    std::optional<std::size_t> low, high, missing;
    for (std::size_t i = begin; i < end; ++i) {
        if (!std::isfinite(value[i])) {
            if (!missing) missing = i;
            continue;
        }
        if (!low || value[i] < value[*low]) low = i;
        if (!high || value[i] > value[*high]) high = i;
    }
    std::vector<std::size_t> found;
    for (const auto& point : {low, high, missing})
        if (point) found.push_back(*point);
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
}

}  // namespace

Curve thinned(const Curve& curve, std::size_t most) {
    const std::size_t points = curve.value.size();
    if (curve.time.size() != points || most < 5) throw std::invalid_argument("thinned: wrong numbers of points");
    if (points <= most) return curve;
    Curve result;
    const auto keep = [&](std::size_t i) {
        result.time.push_back(curve.time[i]);
        result.value.push_back(curve.value[i]);
    };
    const std::size_t inner = points - 2;
    const std::size_t groups = (most - 2) / 3;
    keep(0);
    for (std::size_t group = 0; group < groups; ++group)
        for (const std::size_t i :
             telling_points(curve.value, 1 + inner * group / groups, 1 + inner * (group + 1) / groups))
            keep(i);
    keep(points - 1);
    return result;
}

}  // namespace dmp::report
