// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dmp::models {

/// Twice the mean of the two viscosities of a pair [Pa s].

/// mu_i + mu_j: for a fluid of uniform viscosity (Morris, Fox & Zhu 1997).
struct ArithmeticMean {
    template <class T, class U>
    static auto twice(const T& a, const U& b) {
        return a + b;
    }
};

/// 4 mu_i mu_j / (mu_i + mu_j), which keeps shear stress continuous where the viscosity jumps (Cleary & Monaghan 1999;
/// Hu & Adams 2006). 0 where either is 0.
struct HarmonicMean {
    template <class T, class U>
    static auto twice(const T& a, const U& b) {
        constexpr double smallest = 1e-300;  // 0 / 0 between two fluids without viscosity
        return 4.0 * (a * b) / ((a + b) + smallest);
    }
};

}  // namespace dmp::models
