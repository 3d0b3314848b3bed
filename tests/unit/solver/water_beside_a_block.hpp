// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tests/unit/solver/walled_water.hpp"

namespace dmp::tests {

/// A closed box of water, 20 by 8 particles, with a block of 4 by 6 in its lower left corner that moves to the right at
/// this speed [m/s] from 0.1 s to 0.3 s.
inline WalledWater water_beside_a_block(double speed) {
    WalledWater made(20, 8, {"box", "block"}, [](int, int) { return 1; });
    ParticleSet& set = made.particles;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec& x = set.position[i];
        const std::array<double, 3> depth{x[0], 4 * spacing - x[0], 6 * spacing - x[1]};  // left, right, top
        const auto nearest = std::ranges::min_element(depth);
        if (set.part[i] != 0 || *nearest < 0) continue;
        set.part[i] = 2;
        set.fixed[i] = 1;
        set.wall_normal[i] = nearest == depth.begin() + 2 ? Vec(0, 1, 0) : Vec(nearest == depth.begin() ? -1 : 1, 0, 0);
        set.wall_distance[i] = *nearest;
    }
    made.part(2).velocity =
        std::array{formula_of("t > 0.1 && t < 0.3 ? " + std::to_string(speed) + " : 0"), Expression(), Expression()};
    made.scene.run.duration = 0.4;
    return made;
}

/// The warnings of a void.
inline std::vector<std::string> voids_of(const RunSummary& summary) {
    std::vector<std::string> voids;
    for (const Warning& warning : summary.warnings)
        if (warning.problem.find("a void opened") != std::string::npos) voids.push_back(warning.text());
    return voids;
}

}  // namespace dmp::tests
