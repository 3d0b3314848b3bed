// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

inline Value<double> given(double value) { return {value, SourceLocation{"scene.toml", 1, 1}}; }

/// A scene of spheres, put together by hand.
struct SphereScene {
    Scene scene;
    ParticleSet set;

    SphereScene() {
        scene.dimension = 3;
        scene.run.duration = 1.0;
        scene.output.every = 1.0;
        set.dimension = 3;
        set.box = {Vec::Constant(-1), Vec::Constant(1)};
    }

    int part(const std::string& name, PartKind kind, double youngs_modulus = 1e8) {
        Part made;
        made.name = name;
        made.kind = kind;
        made.density = given(2500.0);
        if (youngs_modulus > 0) {
            made.youngs_modulus = given(youngs_modulus);
            made.poisson_ratio = given(0.3);
        }
        scene.parts.push_back(made);
        set.parts.push_back({name, kind == PartKind::spheres ? PartKind::spheres : PartKind::rigid});
        return static_cast<int>(set.parts.size()) - 1;
    }
    ContactPair& contact(double restitution, double friction) {
        ContactPair pair;
        pair.parts = Value<std::array<std::string, 2>>({"any", "any"}, SourceLocation{"scene.toml", 2, 1});
        pair.restitution = given(restitution);
        pair.friction = given(friction);
        scene.contact_pairs.push_back(pair);
        return scene.contact_pairs.back();
    }
    std::size_t sphere(int of_part, const Vec& position, double radius, const Vec& velocity = Vec::Zero(),
                       const Vec& spin = Vec::Zero()) {
        set.position.push_back(position);
        set.velocity.push_back(velocity);
        set.angular_velocity.push_back(spin);
        set.radius.push_back(radius);
        const double volume = 4 * std::numbers::pi / 3 * std::pow(radius, 3);
        set.volume.push_back(volume);
        set.mass.push_back(2500 * volume);
        set.part.push_back(of_part);
        set.body.push_back(-1);
        set.fixed.push_back(0);
        set.seated.push_back(0);
        set.wall_normal.push_back(Vec::Zero());
        set.wall_distance.push_back(0);
        return set.size() - 1;
    }
    ForceOnPart& force(const std::string& on_part, const std::array<std::string, 3>& formulas, ForceAmount amount) {
        ForceOnPart made;
        made.name = "force " + std::to_string(scene.forces.size());
        made.part = on_part;
        made.force = std::array{expression(formulas[0]), expression(formulas[1]), expression(formulas[2])};
        made.amount = amount;
        scene.forces.push_back(made);
        return scene.forces.back();
    }
    /// A circle at rest that repels the part on both sides.
    MovingShape& circle(const std::string& felt_by, const std::array<std::string, 3>& position, double radius) {
        MovingShape made;
        made.name = std::string("circle");
        made.kind = ShapeKind::circle;
        made.parts = std::vector{felt_by};
        made.position = std::array{expression(position[0]), expression(position[1]), expression(position[2])};
        made.radius = radius;
        made.strength = 0.05;
        made.range = 2e-4;
        scene.moving_shapes.push_back(made);
        return scene.moving_shapes.back();
    }
    static Expression expression(const std::string& formula) { return {formula, formula}; }
    void plane(int of_part, const Vec& point, const Vec& normal) {
        set.wall_planes.push_back({of_part, point, normal.normalized()});
    }
    void triangle(int of_part, const Vec& a, const Vec& b, const Vec& c) {
        const int first = static_cast<int>(set.wall_corners.size());
        for (const Vec& corner : {a, b, c}) set.wall_corners.push_back(corner);
        set.wall_triangles.push_back({of_part, first, first + 1, first + 2});
    }
};

/// A gas of spheres in a periodic box above a plane, of two sizes that differ by a factor: they meet, rub and spin.
inline SphereScene crowd(std::size_t small_ones, double size_ratio, unsigned seed = 1) {
    SphereScene made;
    made.scene.run.duration = given(1e-3);
    made.scene.output.every = 3e-4;
    const int small = made.part("small", PartKind::spheres), large = made.part("large", PartKind::spheres),
              floor = made.part("floor", PartKind::plane);
    made.contact(0.6, 0.4);
    made.plane(floor, Vec::Zero(), Vec::UnitZ());
    made.set.periodic = {true, true, false};
    const double radius = 1e-3, large_radius = radius * size_ratio;
    const double side = std::max(5 * large_radius, std::cbrt(static_cast<double>(small_ones) * 12) * radius);
    made.set.box = {Vec::Zero(), Vec::Constant(side)};
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto vector = [&] { return Vec(unit(random), unit(random), unit(random)); };
    made.sphere(large, Vec(0.02 * side, 0.5 * side, large_radius + 0.2 * radius), large_radius, 0.5 * vector());
    const auto is_free = [&](const Vec& position, double of_radius) {
        for (std::size_t i = 0; i < made.set.size(); ++i) {
            Vec apart = position - made.set.position[i];
            for (int axis = 0; axis < 2; ++axis) apart[axis] -= side * std::round(apart[axis] / side);
            if (apart.norm() < of_radius + made.set.radius[i]) return false;
        }
        return true;
    };
    for (std::size_t k = 0; k < 40 * small_ones && made.set.size() <= small_ones; ++k) {
        const double r = radius * (0.8 + 0.4 * unit(random));
        Vec position = side * vector();
        position[2] = r + position[2] * 0.8;
        if (is_free(position, r))
            made.sphere(small, position, r, 4 * (vector() - Vec::Constant(0.5)), 500 * (vector() - Vec::Constant(0.5)));
    }
    return made;
}

}  // namespace dmp::tests
