// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/solver/walled_water.hpp"

namespace dmp::tests {

inline Value<Expression> placed(const std::string& formula) {
    return {Expression(formula, formula), SourceLocation{"scene.toml", 7, 3}};
}

/// A species of this diffusivity, with a concentration at the start by a formula of x and y.
inline Species species_of(const std::string& name, double diffusivity, const std::string& start) {
    Species species;
    species.name = name;
    species.diffusivity.all = Value<double>(diffusivity);
    species.concentration.all = placed(start);
    return species;
}

/// A strip of resting water along x between two walls, `left` and `right`, 0.1 m between particles, periodic along y.
/// The sound is so slow that diffusivities of about 1 m^2/s rule the step.
inline WalledWater strip(int columns, int rows = 8) {
    WalledWater made(columns, rows, {"left", "right"}, [=](int column, int row) {
        return row < 0 || row >= rows ? 0 : column < 0 ? 1 : 2;
    });
    made.make_periodic(1);
    made.scene.flow.largest_speed = 0.5;
    made.scene.numerics.shifting = 0.0;
    made.scene.output.fields = {FluidField::concentration};
    return made;
}

/// Makes the particles of these columns another part of the given kind, with the name.
inline void make_part(WalledWater& made, const std::string& name, PartKind kind, double from_x, double to_x) {
    Part part = made.scene.parts[0];
    part.name = name;
    part.kind = kind;
    part.layers = 3;
    made.scene.parts.push_back(part);
    ParticleSet& set = made.particles;
    set.parts.push_back({name, kind});
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.part[i] != 0 || set.position[i][0] < from_x || set.position[i][0] > to_x) continue;
        set.part[i] = static_cast<int>(set.parts.size()) - 1;
        if (kind == PartKind::fluid) continue;
        set.fixed[i] = 1;
        // A slab of solid: each particle's surface is the nearer one.
        const bool left = set.position[i][0] < 0.5 * (from_x + to_x);
        set.wall_normal[i] = Vec(left ? -1 : 1, 0, 0);
        set.wall_distance[i] = left ? set.position[i][0] - from_x : to_x - set.position[i][0];
    }
}

/// A stirred channel with all that species know: a floor that is held, a lid that slides and gives off, a wall of solid
/// across it and a rod of springs that conduct, unlike liquids, uptake in some of them; a species that does not
/// diffuse; one at which the rod is held; shifting.
inline SceneAndParticles stirred_mixture() {
    WalledWater made(14, 12, {"floor", "lid"}, [](int column, int row) {
        return column < 0 || column >= 14 ? 0 : row < 0 ? 1 : 2;
    });
    made.make_periodic(0);
    Scene& scene = made.scene;
    made.part(2).surface_velocity = std::array{formula_of("0.5"), Expression(), Expression()};
    scene.flow.acceleration = {formula_of("0.5 * sin(2 * pi * y / 1.2)"), formula_of("0.5 * sin(2 * pi * x / 1.4)"),
                               Expression()};
    make_part(made, "block", PartKind::rigid, 0.4, 0.7);
    make_part(made, "oil", PartKind::fluid, 1.0, 1.4);
    Species drug = species_of("drug", 0, "x");
    drug.diffusivity.all.reset();
    drug.diffusivity.parts = {{"water", 0.02}, {"oil", 0.005}, {"block", 0.01}, {"flags", 0.03}};
    drug.wall_concentration.parts = {{"floor", placed("0.5 + 0.2 * sin(t) * x")}};
    drug.wall_flux.parts = {{"lid", placed("0.1 * t")}};
    drug.uptake.parts = {{"oil", 0.5}, {"block", 0.2}, {"flags", 1.0}};
    Species oxygen = species_of("oxygen", 0.01, "0.5");
    oxygen.wall_concentration.parts = {{"flags", placed("0.3 + 0.1 * sin(t) * x")}};
    scene.species = {drug, species_of("marker", 0, "y > 0.6 ? 1 : 0"), oxygen};
    scene.output.fields = {FluidField::velocity, FluidField::concentration};
    scene.run.duration = 0.6;
    scene.output.every = 0.3;
    Measure uptake;
    uptake.name = std::string("uptake");
    uptake.kind = MeasureKind::wall_flux;
    uptake.part = std::string("floor");
    uptake.species = std::string("drug");
    Measure profile;
    profile.name = std::string("profile");
    profile.kind = MeasureKind::profile;
    profile.species = std::string("marker");
    profile.axis = Axis::y;
    profile.bins = 5;
    Measure spread = profile;
    spread.name = std::string("spread");
    spread.species = std::string("drug");
    spread.kind = MeasureKind::spread;
    Measure taken_up = uptake, to_rod = uptake;
    taken_up.name = std::string("taken_up");
    taken_up.kind = MeasureKind::uptake;
    taken_up.part = std::string("oil");
    to_rod.name = std::string("to_rod");
    to_rod.part = std::string("flags");
    to_rod.species = std::string("oxygen");
    scene.measures = {uptake, taken_up, to_rod, profile, spread};
    SceneAndParticles mixture{scene, made.particles};
    add_flags(mixture);
    add_rod(mixture, Vec(1.2, 0.5, 0), 0);
    mixture.scene.contact.range = 0.0;
    // The drive stirs the liquids alone: it is taken back from the nodes of 10 kg, which follow the liquid.
    ForceOnPart back;
    back.name = std::string("back");
    back.part = std::string("flags");
    back.amount = ForceAmount::per_particle;
    back.force =
        std::array{formula_of("-5 * sin(2 * pi * y / 1.2)"), formula_of("-5 * sin(2 * pi * x / 1.4)"), Expression()};
    mixture.scene.forces = {back};
    return mixture;
}

/// Concentrations of a frame by x, means over the rows.
inline std::map<float, double> by_x(const Frame& frame, const std::string& field = "concentration") {
    std::map<float, double> mean;
    std::map<float, int> count;
    const FrameGroup& fluid = *group_of(frame, "fluid");
    const FrameField& values = *field_of(fluid, field);
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const float x = fluid.position[3 * k];
        mean[x] += values.values[k];
        ++count[x];
    }
    for (auto& [x, value] : mean) value /= count[x];
    return mean;
}

}  // namespace dmp::tests
