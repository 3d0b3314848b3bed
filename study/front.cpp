// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/front.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace dmp::study {

std::vector<std::size_t> front_of(const std::vector<CostAndError>& tried) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < tried.size(); ++i)
        if (!std::isnan(tried[i].error) && !std::isnan(tried[i].cost)) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::tuple(tried[i].cost, tried[i].error); });
    std::vector<std::size_t> front;
    double smallest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (tried[i].error >= smallest) continue;
        smallest = tried[i].error;
        front.push_back(i);
    }
    return front;
}

std::optional<std::size_t> cheapest_within(const std::vector<CostAndError>& tried, double error) {
    for (const std::size_t i : front_of(tried))
        if (tried[i].error <= error) return i;
    return {};
}

}  // namespace dmp::study
