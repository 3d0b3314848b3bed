// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "tests/unit/solver/walled_water.hpp"

namespace dmp::tests {

/// Two closed chambers of water, 7 by 8 and 7 by 8 particles, with a wall of two columns between them. The lid of the
/// left one slides, the pressure in it is higher by 500 Pa. `gap`: rows of the wall that are water, from the bottom.
/// `periodic`: no walls to the left and the right, where one chamber goes on in the other.
inline WalledWater two_chambers(int gap = 0, bool periodic = false) {
    constexpr int columns = 16;
    WalledWater made(columns, 8, {"box", "lid", "baffle"}, [=](int column, int row) {
        if (periodic && (column < 0 || column >= columns)) return 0;
        return row >= 8 && column < 7 ? 2 : 1;
    });
    if (periodic) made.make_periodic(0);
    ParticleSet& set = made.particles;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec& x = set.position[i];
        const double from_left = x[0] - 7 * spacing, from_right = 9 * spacing - x[0];
        if (set.part[i] != 0 || from_left < 0 || from_right < 0 || x[1] < gap * spacing) continue;
        set.part[i] = 3;
        set.fixed[i] = 1;
        set.wall_normal[i] = Vec(from_left < from_right ? -1 : 1, 0, 0);
        set.wall_distance[i] = std::min(from_left, from_right);
    }
    made.part(2).surface_velocity = std::array{formula_of("0.1"), Expression(), Expression()};
    made.scene.flow.initial_pressure = formula_of("x < 0.8 ? 500 : 0");
    made.scene.flow.largest_pressure = 1000.0;
    made.scene.run.duration = 2.0;
    return made;
}

/// Mean pressure of a frame's water on one side of the wall's middle [Pa].
inline double mean_pressure(const Frame& frame, bool left) {
    const FrameGroup& water = frame.groups.front();
    const auto field = std::ranges::find(water.fields, "pressure", &FrameField::name);
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < water.size(); ++i) {
        if ((water.position[3 * i] < 8 * spacing) != left) continue;
        sum += field->values[i];
        ++count;
    }
    return sum / count;
}

}  // namespace dmp::tests
