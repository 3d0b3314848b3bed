// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/results/frame.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests {

inline void add_particle(FrameGroup& group, float x, float y, int part) {
    group.id.push_back(static_cast<std::int64_t>(group.id.size()));
    group.part.push_back(part);
    group.position.insert(group.position.end(), {x, y, 0.0F});
}

/// A channel 40 x 10 spacings with parabolic flow, two rows of walls on each side (first frame only)
/// and a chain of 9 bonded particles. Speeds grow with the time.
inline Frame channel_frame(double time, bool with_walls) {
    Frame frame;
    frame.time = time;
    frame.step = std::lround(time * 1000);
    frame.spacing = 0.001;
    frame.parts = {"water", "wall", "flap"};

    const auto dx = static_cast<float>(frame.spacing);
    FrameGroup fluid;
    fluid.name = "fluid";
    FrameField velocity{"velocity", "m/s", 3, {}};
    FrameField pressure{"pressure", "Pa", 1, {}};
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 10; ++j) {
            const float y = (static_cast<float>(j) + 0.5F) * dx;
            add_particle(fluid, (static_cast<float>(i) + 0.5F) * dx, y, 0);
            const float height = y / (10 * dx);
            velocity.values.insert(velocity.values.end(),
                                   {static_cast<float>(time) * height * (1 - height), 0.25F * height, 0.0F});
            pressure.values.push_back(static_cast<float>(20 - i));
        }
    fluid.fields = {velocity, pressure};

    FrameGroup solid;
    solid.name = "solid";
    FrameField strain{"strain", "1", 1, {}};
    for (int i = 0; i < 9; ++i) {
        add_particle(solid, 0.02F + 0.001F * static_cast<float>(i), 0.004F, 2);
        if (i == 0) continue;
        solid.bond_ends.insert(solid.bond_ends.end(), {i - 1, i});
        strain.values.push_back(0.01F * static_cast<float>(i));
    }
    solid.bond_fields = {strain};

    frame.groups = {fluid, solid};
    if (with_walls) {
        FrameGroup walls;
        walls.name = "walls";
        for (int i = 0; i < 40; ++i)
            for (const int j : {-2, -1, 10, 11})
                add_particle(walls, (static_cast<float>(i) + 0.5F) * dx, (static_cast<float>(j) + 0.5F) * dx, 1);
        frame.groups.push_back(walls);
    }
    return frame;
}

}  // namespace dmp::tests
