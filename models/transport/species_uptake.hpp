// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "models/uses.hpp"

namespace dmp::models {

/// First-order uptake of a species, dc/dt = -k c: a reaction, a decay, consumption by cells. A particle whose amount is
/// w and which neighbours supply at the rate r has after a step, with x = k dt,
///   w' = exp(-x) w + r dt (1 - exp(-x)) / x
/// (exponential Euler: Cox & Matthews 2002, eq. 4), which is exact where r does not change: an even concentration
/// decays as exp(-k t), and a steady state, r = k w, stays what it is, in steps of any length. r may be that before the
/// step or, for backward Euler, that after it. Of first order otherwise, as the diffusion is. No step is unstable.
///
/// It is the same as losing a share before and after r dt is added,
///   w' = [w x / (exp(x) - 1) + r dt] (1 - exp(-x)) / x
/// so that pairs hand over r dt whole and what is lost is known exactly.
struct FirstOrderUptake {
    double rate;  ///< k [1/s], at least 0

    /// x / (exp(x) - 1): the share of w that is left before r dt is added.
    [[nodiscard]] double left_before(double dt) const {
        const double x = rate * dt;
        return x > 0 ? x / std::expm1(x) : 1;
    }
    /// (1 - exp(-x)) / x: the share of both that is left afterwards.
    [[nodiscard]] double left_after(double dt) const {
        const double x = rate * dt;
        return x > 0 ? -std::expm1(-x) / x : 1;
    }
};

}  // namespace dmp::models
