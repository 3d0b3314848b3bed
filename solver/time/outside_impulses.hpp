// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace dmp::solver {

/// Impulses that moving particles have been given from outside [N s].
struct OutsideImpulses {
    std::array<double, 3> of_body_forces{}, of_fixed{}, of_drag{};
};

}  // namespace dmp::solver
