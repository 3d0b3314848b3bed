// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/grid_convergence.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace dmp::study {

namespace {

constexpr double safety = 1.25, lowest_order = 0.5, highest_order = 4;

/// (h1^p - h2^p) / (h2^p - h3^p), which grows with p.
double ratio_at(const std::array<GridValue, 3>& values, double order) {
    const double a = std::pow(values[0].spacing / values[2].spacing, order);
    const double b = std::pow(values[1].spacing / values[2].spacing, order);
    return (a - b) / (b - 1);
}

/// The order at which the three values lie on one curve, by bisection.
std::optional<double> observed_order(const std::array<GridValue, 3>& values, std::string& why_not) {
    const double first = values[0].value - values[1].value, second = values[1].value - values[2].value;
    if (first * second <= 0) {
        why_not = "the values do not change in one direction";
        return {};
    }
    const double ratio = first / second;
    double low = lowest_order, high = highest_order;
    if (ratio < ratio_at(values, low) || ratio > ratio_at(values, high)) {
        why_not =
            fmt::format("the observed order is {}",
                        ratio < ratio_at(values, low) ? fmt::format("below {}", low) : fmt::format("above {}", high));
        return {};
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (ratio < ratio_at(values, middle) ? high : low) = middle;
    }
    return (low + high) / 2;
}

std::optional<GridConvergence> of_three(const std::array<GridValue, 3>& values, std::string& why_not) {
    const auto order = observed_order(values, why_not);
    if (!order) return {};
    const double finest = values[2].value;
    const double correction =
        (finest - values[1].value) / (std::pow(values[1].spacing / values[2].spacing, *order) - 1);
    return GridConvergence{*order, finest + correction, safety * std::abs(correction)};
}

}  // namespace

std::optional<GridConvergence> grid_convergence(const std::vector<GridValue>& coarse_to_fine, std::string& why_not) {
    const std::size_t count = coarse_to_fine.size();
    if (count < 4) {
        why_not = "there are fewer than four spacings";
        return {};
    }
    const auto three_up_to = [&](std::size_t last) {
        return std::array{coarse_to_fine[last - 2], coarse_to_fine[last - 1], coarse_to_fine[last]};
    };
    const auto coarse = of_three(three_up_to(count - 2), why_not);
    if (!coarse) return {};
    const auto fine = of_three(three_up_to(count - 1), why_not);
    if (!fine) return {};
    if (std::abs(coarse->limit - fine->limit) > coarse->uncertainty + fine->uncertainty) {
        why_not = "the limits of two sets of spacings do not agree";
        return {};
    }
    return fine;
}

}  // namespace dmp::study
