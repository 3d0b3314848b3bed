// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/forcing/driving.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

inline Expression driving_formula(const std::string& text) { return Expression(text, text); }

inline ForceOnPart force_on(const std::string& part, const std::string& x, const std::string& y, ForceAmount amount) {
    ForceOnPart force;
    force.name = std::string("push");
    force.part = part;
    force.force = std::array{driving_formula(x), driving_formula(y), Expression()};
    force.amount = amount;
    return force;
}

/// A scene and the few particles that feel what it drives with.
struct DrivenBead {
    Scene scene;
    ParticleSet particles;
};

/// One sphere of 2 kg, in a part "bead", and a parabola of focal length 1/4 m that keeps it inside.
inline DrivenBead bead_in_a_parabola() {
    DrivenBead made;
    made.particles.dimension = 3;
    made.particles.parts = {{"bead", PartKind::spheres}};
    made.particles.position = {Vec::Zero()};
    made.particles.mass = {2};
    made.particles.part = {0};
    made.particles.box = {Vec::Constant(-1), Vec::Constant(1)};
    MovingShape shape;
    shape.name = std::string("ghost");
    shape.kind = ShapeKind::parabola;
    shape.parts = std::vector<std::string>{"bead"};
    shape.position = std::array{driving_formula("0.3 * t"), Expression(), Expression()};
    shape.half_width = 1.0;
    shape.height = 1.0;
    shape.strength = 50.0;
    shape.range = 0.1;
    shape.side = PushedSide::inside;
    made.scene.moving_shapes = {shape};
    made.scene.forces = {force_on("bead", "0", "-20", ForceAmount::total)};  // 10 m/s^2
    return made;
}

}  // namespace dmp::tests
