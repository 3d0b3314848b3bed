// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/elastic/spring_network.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/statics.hpp"

namespace dmp::tests {
using V2 = Vector<double, 2>;
using Vectors = std::vector<V2>;
using PlaneBody = SpringNetwork<2>;

/// A ladder along x with 90-degree hinges at every corner, spacing a = 1, node mass m = 1, k_b = 1; nodes 2c (upper)
/// and 2c + 1 (lower) of column c.
struct LadderShape {
    int cells = 20;
    double hinge_stiffness = 0.5;  ///< k_a / (k_b a^2)
    bool clamped = true;           ///< the left column never moves
};

inline ParticleSet ladder(const LadderShape& shape) {
    ParticleSet set;
    set.spacing = 1;
    set.box = {Vec(-1, -1, 0), Vec(shape.cells + 1, 1, 0)};
    set.parts = {{"beam", PartKind::elastic}};
    for (int column = 0; column <= shape.cells; ++column)
        for (const double y : {0.5, -0.5}) {
            set.position.emplace_back(column, y, 0);
            set.volume.push_back(1);
            set.mass.push_back(1);
            set.part.push_back(0);
            set.body.push_back(0);
            set.fixed.push_back(shape.clamped && column == 0 ? 1 : 0);
            set.seated.push_back(0);
            set.wall_normal.emplace_back(Vec::Zero());
            set.wall_distance.push_back(0);
        }
    const auto hinge = [&](int a, int centre, int b) {
        const Vec p = set.position[a] - set.position[centre], q = set.position[b] - set.position[centre];
        set.hinges.push_back({a, centre, b, std::atan2(p[0] * q[1] - p[1] * q[0], p.dot(q)), shape.hinge_stiffness});
    };
    for (int column = 0; column <= shape.cells; ++column) {
        const int up = 2 * column, low = up + 1, next_up = up + 2, next_low = up + 3;
        set.bonds.push_back({up, low, 1, 1});
        if (column == shape.cells) break;
        set.bonds.push_back({up, next_up, 1, 1});
        set.bonds.push_back({low, next_low, 1, 1});
        hinge(next_up, up, low);
        hinge(up, low, next_low);
        hinge(low, next_low, next_up);
        hinge(next_low, next_up, up);
    }
    return set;
}

/// EA, EI and GA_s of it by theory.
inline double axial_stiffness() { return 4; }
inline double bending_stiffness(double k_a) { return 1 + 2 * k_a; }
inline double shear_stiffness(double k_a) { return 8 * k_a; }

inline Scene scene_with(const Part& part, SpringStepping stepping) {
    Scene scene;
    scene.parts.push_back(part);
    scene.numerics.spring_stepping = stepping;
    return scene;
}

/// Loads `force` [N] shared by the two end nodes.
inline Vectors end_load(const ParticleSet& set, const V2& force) {
    Vectors load(set.size(), V2::zero());
    load[set.size() - 1] = load[set.size() - 2] = 0.5 * force;
    return load;
}

}  // namespace dmp::tests
