// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/uses.hpp"

namespace dmp::study {

/// A number that a run with this spacing gives.
struct GridValue {
    double spacing = 0;  ///< [m]
    double value = 0;
};

/// What the values of ever smaller spacings go to.
struct GridConvergence {
    double order = 0;        ///< p of value = limit + C spacing^p, observed
    double limit = 0;        ///< Richardson's extrapolation to spacing 0
    double uncertainty = 0;  ///< of the value with the smallest spacing: grid convergence index, in the value's unit
};

/// By the three smallest spacings, with a factor of safety of 1.25 (Roache 1998, Verification and Validation in
/// Computational Science and Engineering, ch. 5). `coarse_to_fine`: four or more, with spacings that fall.
///
/// None, with `why_not` said, where that would not be honest: fewer than four values; values that do not change in one
/// direction, as noise does; an order outside 0.5 to 4, where the error is not yet that of small spacings; two
/// sets of three values whose limits lie farther apart than their uncertainties together.
[[nodiscard]] std::optional<GridConvergence> grid_convergence(const std::vector<GridValue>& coarse_to_fine,
                                                              std::string& why_not);

}  // namespace dmp::study
