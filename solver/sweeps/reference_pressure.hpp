// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace dmp::solver {

/// An affine pressure that is subtracted from the fluid's in sums over pairs (corrected scheme): a pressure makes the
/// arrangement of the particles stiff, and resists every flow, though its gradient is nothing or known.
///   P(x) = level + slope . (x - centre)   [Pa]
struct ReferencePressure {
    double level = 0;
    std::array<double, 3> slope{}, centre{};
};

}  // namespace dmp::solver
