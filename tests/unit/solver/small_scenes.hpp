// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "mesher/mesh.hpp"
#include "scene/read_scene.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// Keeps every frame.
class KeptFrames : public FrameSink {
  public:
    void write(const Frame& frame) override { frames.push_back(frame); }
    [[nodiscard]] std::vector<double> times() const {
        std::vector<double> times;
        for (const Frame& frame : frames) times.push_back(frame.time);
        return times;
    }
    std::vector<Frame> frames;
};

struct SceneAndParticles {
    Scene scene;
    ParticleSet particles;
};

/// The scheme of the published studies with its defaults.
inline void use_plain_scheme(Scene& scene) {
    scene.numerics.scheme = FluidScheme::plain;
    scene.numerics.viscous_law = ViscousLaw::of<MorrisViscosity>();
    scene.numerics.shifting = 4.0;
    scene.numerics.step_factor = 0.3;
    scene.contact.range = 1.0;
}

/// A case of the repository, read and meshed; `folder` is relative to cases/.
inline SceneAndParticles case_of(const std::string& folder, const std::vector<std::string>& overrides) {
    SceneAndParticles made;
    made.scene = read_scene(std::string(DMP_SOURCE_DIR) + "/cases/" + folder, overrides);
    GeometryOptions cad_geometry;
    cad_geometry.file = (std::filesystem::path(made.scene.directory) / made.scene.geometry.file.value).string();
    cad_geometry.unit = made.scene.geometry.unit;
    cad_geometry.chord_error = 1e-3 * made.scene.particles.spacing;
    for (const auto& [name, value] : made.scene.geometry.parameters) cad_geometry.parameters[name] = value;
    made.particles = mesh(read_geometry(cad_geometry), made.scene).particles;
    return made;
}

/// A square of water, 8 x 8 particles 0.1 m apart, periodic in x and y: nothing to hold it back.
inline SceneAndParticles endless_water(const std::string& acceleration_x = "0") {
    SceneAndParticles made;
    Scene& scene = made.scene;
    constexpr int side = 8;
    scene.particles.spacing = 0.1;
    Part water;
    water.name = std::string("water");
    water.kind = PartKind::fluid;
    water.density = 1000.0;
    water.viscosity = 1.0;
    scene.parts = {water};
    scene.flow.acceleration[0] = Expression(acceleration_x, acceleration_x);
    scene.flow.periodic = {true, true, false};
    scene.flow.largest_speed = 1.0;
    scene.run.duration = 1.0;
    scene.output.every = 0.25;
    scene.output.fields = {FluidField::velocity, FluidField::pressure, FluidField::density};

    ParticleSet& set = made.particles;
    set.spacing = 0.1;
    set.box = {Vec::Zero(), Vec(0.1 * side, 0.1 * side, 0)};
    set.periodic = {true, true, false};
    set.parts = {{"water", PartKind::fluid}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            set.position.emplace_back(0.1 * (column + 0.5), 0.1 * (row + 0.5), 0);
            set.volume.push_back(0.01);
            set.mass.push_back(10);
            set.part.push_back(0);
            set.body.push_back(-1);
            set.fixed.push_back(0);
            set.seated.push_back(0);
            set.wall_normal.emplace_back(Vec::Zero());
            set.wall_distance.push_back(0);
        }
    return made;
}

/// Adds an elastic solid "flags" to the scene.
inline void add_flags(SceneAndParticles& made) {
    Part flags;
    flags.name = std::string("flags");
    flags.kind = PartKind::elastic;
    made.scene.parts.push_back(flags);
    made.particles.parts.push_back({"flags", PartKind::elastic});
}

/// Adds one bond of two nodes, at `place` and 0.1 m above it, as body `body` of the last part.
inline void add_rod(SceneAndParticles& made, const Vec& position, int body) {
    ParticleSet& set = made.particles;
    const int first = static_cast<int>(set.size());
    // Copies: `place` may be a position of the set itself, which is about to grow.
    for (const Vec& node : std::array<Vec, 2>{position, position + Vec(0, 0.1, 0)}) {
        set.position.push_back(node);
        set.volume.push_back(0.01);
        set.mass.push_back(10);
        set.part.push_back(static_cast<int>(set.parts.size()) - 1);
        set.body.push_back(body);
        set.fixed.push_back(0);
        set.seated.push_back(0);
        set.wall_normal.emplace_back(Vec::Zero());
        set.wall_distance.push_back(0);
    }
    set.bonds.push_back({first, first + 1, 0.1, 1e3});
}

inline const FrameGroup* group_of(const Frame& frame, const std::string& name) {
    for (const FrameGroup& group : frame.groups)
        if (group.name == name) return &group;
    return nullptr;
}

inline const FrameField* field_of(const FrameGroup& group, const std::string& name) {
    for (const FrameField& field : group.fields)
        if (field.name == name) return &field;
    return nullptr;
}

}  // namespace dmp::tests
