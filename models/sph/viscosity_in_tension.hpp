// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "models/pair.hpp"

namespace dmp::models {

/// The least viscosity of a pair whose reduced pressure is negative (corrected scheme):
///   mu_ij >= - dt (p'_i + p'_j) / 2   [Pa s]
/// A pressure p' makes the arrangement of the particles stiff in proportion to p'. Shifting relaxes the arrangement
/// within a few steps, so that the stiffness acts as an added viscosity of about 0.75 p' dt: negative where p' < 0,
/// where flow at the scale of the spacing grows unless the fluid's own viscosity is larger. The least viscosity
/// exceeds the negative one by a third (docs/scheme.md). Fluids that are viscous enough at the spacing are not changed.
struct ViscosityInTension {
    double time = 0;  ///< dt [s]

    /// Twice the viscosity of a pair, from twice the mean of the fluids' own [Pa s].
    template <class P, class T>
    [[nodiscard]] auto at_least(const P& p, const T& twice_mean) const {
        using std::max;
        const auto least = -time * (p.i.pressure + p.j.pressure);
        using Wide = decltype(least + twice_mean);
        return max(Wide(least), Wide(twice_mean));
    }
};

}  // namespace dmp::models
