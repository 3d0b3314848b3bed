// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// Layers of liquids between two resting walls at y = 0 and y = width, periodic along x; particles on a lattice.
struct LayeredChannel {
    struct Layer {
        std::string name;
        int rows;
        double viscosity;  ///< dynamic [Pa s]
    };
    std::vector<Layer> layers;
    double spacing = 5e-5;  ///< [m]
    int columns = 8;
    double speed = 1.25e-5;          ///< largest expected [m/s]; sound is ten times as fast
    std::string acceleration = "0";  ///< along x, of t, x, y [m/s^2]
    double duration = 1;             ///< [s]
    static constexpr double density = 1000;

    [[nodiscard]] int rows() const {
        int all = 0;
        for (const Layer& layer : layers) all += layer.rows;
        return all;
    }
    [[nodiscard]] double width() const { return rows() * spacing; }
};

inline void add_particle(ParticleSet& set, const Vec& position, int part, double mass) {
    set.position.push_back(position);
    set.volume.push_back(set.spacing * set.spacing);
    set.mass.push_back(mass);
    set.part.push_back(part);
    set.body.push_back(-1);
    set.fixed.push_back(set.parts[part].kind == PartKind::rigid ? 1 : 0);
    set.seated.push_back(0);
    set.wall_normal.emplace_back(Vec::Zero());
    set.wall_distance.push_back(0);
}

inline SceneAndParticles layered(const LayeredChannel& channel) {
    SceneAndParticles made;
    Scene& scene = made.scene;
    ParticleSet& set = made.particles;
    const double dx = channel.spacing, mass = LayeredChannel::density * dx * dx;
    scene.particles.spacing = set.spacing = dx;
    for (const auto& layer : channel.layers) {
        Part liquid;
        liquid.name = layer.name;
        liquid.kind = PartKind::fluid;
        liquid.density = LayeredChannel::density;
        liquid.viscosity = layer.viscosity;
        scene.parts.push_back(liquid);
        set.parts.push_back({layer.name, PartKind::fluid});
    }
    Part wall;
    wall.name = std::string("wall");
    wall.kind = PartKind::rigid;
    wall.layers = 3;
    scene.parts.push_back(wall);
    const int wall_part = static_cast<int>(set.parts.size());
    set.parts.push_back({"wall", PartKind::rigid});
    scene.flow.acceleration[0] = Expression(channel.acceleration, channel.acceleration);
    set.periodic = {true, false, false};
    scene.flow.periodic = {true, false, false};
    scene.flow.largest_speed = channel.speed;
    scene.contact.range = 0.0;
    scene.run.duration = channel.duration;
    scene.output.every = channel.duration;
    scene.output.fields = {FluidField::velocity};
    scene.numerics.viscosity_stepping = ViscosityStepping::implicitly;

    set.box = {Vec(0, -3 * dx, 0), Vec(channel.columns * dx, channel.width() + 3 * dx, 0)};
    const auto position = [dx](int column, int row) { return Vec((column + 0.5) * dx, (row + 0.5) * dx, 0); };
    int row = 0;
    for (std::size_t layer = 0; layer < channel.layers.size(); ++layer)
        for (int end = row + channel.layers[layer].rows; row < end; ++row)
            for (int column = 0; column < channel.columns; ++column)
                add_particle(set, position(column, row), static_cast<int>(layer), mass);
    for (int depth = 0; depth < 3; ++depth)
        for (const bool above : {false, true})
            for (int column = 0; column < channel.columns; ++column) {
                add_particle(set, position(column, above ? channel.rows() + depth : -1 - depth), wall_part, mass);
                set.wall_normal.back() = Vec(0, above ? -1 : 1, 0);
                set.wall_distance.back() = (depth + 0.5) * dx;
            }
    return made;
}

/// L2 difference of the fluid's velocity in a frame from (expected(y), 0), relative to that.
inline double profile_error(const Frame& frame, const std::function<double(double)>& expected) {
    const FrameGroup& fluid = *group_of(frame, "fluid");
    const FrameField& velocity = *field_of(fluid, "velocity");
    double square = 0, reference = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double u = expected(fluid.position[3 * k + 1]);
        square += std::pow(velocity.values[3 * k] - u, 2) + std::pow(velocity.values[3 * k + 1], 2);
        reference += u * u;
    }
    return std::sqrt(square / reference);
}

}  // namespace dmp::tests
