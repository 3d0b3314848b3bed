// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/unlisted_value.hpp"

namespace dmp::models {

enum class BreakCriterion { force, strain };

/// A bond breaks when its tension F = 2 k_b (r - r0) [N], or its strain (r - r0) / r0 [-], exceeds a limit. With a
/// force limit it breaks at
///   r = r0 + F_limit / (2 k_b)
/// and releases k_b (r - r0)^2. A compressed bond does not break. The dashpot force is not included.
struct BondBreak {
    BreakCriterion criterion = BreakCriterion::force;
    double limit = 0;  ///< [N] or [-]

    /// Relative excess over the limit, load / limit - 1; the bond breaks if this is positive.
    [[nodiscard]] double excess(double stretch, double rest_length, double stiffness) const {
        switch (criterion) {
            case BreakCriterion::force:
                return 2 * stiffness * stretch / limit - 1;
            case BreakCriterion::strain:
                return stretch / rest_length / limit - 1;
        }
        unlisted_value(criterion);
    }
};

}  // namespace dmp::models
