// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "study/uses.hpp"

namespace dmp::study {

/// What a setting took, and how wrong it was.
struct CostAndError {
    double cost = 0;   ///< e.g. processor time [s]; NaN: not known
    double error = 0;  ///< NaN: none, as of a run that failed
};

/// Indices of those that no other one beats in both cost and error (or equals in one and beats in the other), cheapest
/// first: each next one costs more and has a smaller error. Of equal ones the first.
[[nodiscard]] std::vector<std::size_t> front_of(const std::vector<CostAndError>& tried);

/// The cheapest one with at most this error.
[[nodiscard]] std::optional<std::size_t> cheapest_within(const std::vector<CostAndError>& tried, double error);

}  // namespace dmp::study
