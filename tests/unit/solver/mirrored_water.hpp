// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/modules.hpp"
#include "walled_water.hpp"

namespace dmp::tests {

/// A cell of a Taylor-Green vortex, driven by a force and without walls: the square [0, 1]^2 between four planes of
/// symmetry, or the period of 2 x 2 such cells.
inline WalledWater vortex(bool mirrored) {
    const int side = mirrored ? 10 : 20;
    WalledWater made(side, side, {}, [](int, int) { return 0; });
    if (mirrored) {
        made.mirror({BoxSide::x_low, BoxSide::x_high, BoxSide::y_low, BoxSide::y_high});
    } else {
        made.make_periodic(0);
        made.make_periodic(1);
    }
    made.scene.flow.acceleration = {formula_of("4 * sin(pi * x) * cos(pi * y)"),
                                    formula_of("-4 * cos(pi * x) * sin(pi * y)"), Expression()};
    made.scene.parts[0].viscosity = 10.0;
    made.scene.run.duration = 0.6;
    made.scene.output.every = 0.3;
    return made;
}

}  // namespace dmp::tests
