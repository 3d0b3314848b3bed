// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A spring node's inertia is its body's, whatever volume it fills for the liquid.
#include <gtest/gtest.h>

#include "driven_scenes.hpp"
#include "small_scenes.hpp"
#include "solver/elastic/node_mass.hpp"
#include "solver/run/setup.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_inertial_mass_tests {
namespace {

/// Water that is pushed along x, with a rod in the place of two of its particles.
SceneAndParticles water_with_a_rod(double node_mass) {
    SceneAndParticles made = endless_water();
    // On the water alone: gravity would act on the rod too.
    made.scene.forces = {force_on("water", "10", "0", ForceAmount::per_particle)};
    add_flags(made);
    ParticleSet& set = made.particles;
    const Vec position = set.position[27];
    const auto take_out = [&](std::size_t i) {
        const auto at = static_cast<std::ptrdiff_t>(i);
        const auto erase = [at](auto& values) { values.erase(values.begin() + at); };
        erase(set.position);
        erase(set.volume);
        erase(set.mass);
        erase(set.part);
        erase(set.body);
        erase(set.fixed);
        erase(set.seated);
        erase(set.wall_normal);
        erase(set.wall_distance);
    };
    take_out(35);  // above it
    take_out(27);
    add_rod(made, position, 0);
    for (std::size_t i = set.size() - 2; i < set.size(); ++i) set.mass[i] = node_mass;
    made.scene.contact.range = 0.0;
    return made;
}

/// The frame at the end of the first step of 0.1 ms.
Frame after_one_step(const SceneAndParticles& made) {
    Scene scene = made.scene;
    scene.run.duration = 1e-4;
    scene.output.every = scene.output.measure_every = 1e-4;
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    const RunSummary summary = Simulation(scene, made.particles, 1).run(options);
    EXPECT_EQ(summary.steps, 1);
    return kept.frames.back();
}

TEST(InertialMass, of_spring_nodes_does_not_enter_the_liquids_sums) {
    const SceneAndParticles light = water_with_a_rod(10), heavy = water_with_a_rod(90);
    for (const SceneAndParticles* made : {&light, &heavy}) {
        const ParticleStore store(made->particles, rest_densities(made->scene, made->particles));
        const ParticleGroup& nodes = store.of(PartKind::elastic);
        ASSERT_EQ(nodes.owned(), 2U);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(nodes.data(Field::volume)[i], 0.01);
            EXPECT_EQ(nodes.data(Field::mass)[i], 1000 * 0.01) << "of the liquid that it displaces";
        }
    }
    const Frame of_light = after_one_step(light), of_heavy = after_one_step(heavy);
    EXPECT_EQ(field_of(*group_of(of_light, "fluid"), "velocity")->values,
              field_of(*group_of(of_heavy, "fluid"), "velocity")->values);
}

TEST(InertialMass, of_spring_nodes_resists_the_liquids_push) {
    // By viscosity after some steps; the rod as a whole keeps the momentum that it is given.
    const auto momentum_and_speed = [](double node_mass) {
        SceneAndParticles made = water_with_a_rod(node_mass);
        made.scene.parts[0].viscosity = 100.0;
        made.scene.run.duration = made.scene.output.every = 0.01;
        KeptFrames kept;
        RunOptions options;
        options.sink = &kept;
        const RunSummary summary = Simulation(made.scene, made.particles, 1).run(options);
        EXPECT_LT(summary.momentum_residual, 1e-12);
        EXPECT_NEAR(summary.end.mass, 62 * 10 + 2 * node_mass, 1e-9);
        return field_of(*group_of(kept.frames.back(), "solid"), "velocity")->values[0];
    };
    const double light = momentum_and_speed(10), heavy = momentum_and_speed(90);
    EXPECT_GT(light, 0);
    EXPECT_NEAR(light / heavy, 9, 0.5);
}

/// A set of one fluid particle and one node of an elastic part, both of 1 cm^3.
SceneAndParticles one_node_of(const Part& part, double mass) {
    SceneAndParticles made;
    made.scene.dimension = 3;
    Part water;
    water.name = std::string("water");
    water.kind = PartKind::fluid;
    water.density = 1000.0;
    water.enabled = true;
    made.scene.parts = {water, part};
    ParticleSet& set = made.particles;
    set.parts = {{"water", PartKind::fluid}, {"leaflet", PartKind::elastic}};
    set.dimension = 3;
    set.position = {Vec(0, 0, 0), Vec(0.01, 0, 0)};
    set.volume = {1e-6, 1e-6};
    set.mass = {1e-3, mass};
    set.part = {0, 1};
    return made;
}

Part leaflet_of(double density) {
    Part part;
    part.name = std::string("leaflet");
    part.kind = PartKind::elastic;
    part.enabled = true;
    if (density > 0) part.density = Value<double>(density, SourceLocation{"scene.toml", 1});
    return part;
}

/// Beyond its buoyancy [kg], given with the material's volume [m^3].
double weight_in_water(double density, double volume) {
    const SceneAndParticles made = one_node_of(leaflet_of(density), density * volume);
    return node_masses(made.scene, made.particles, 1000)[1] - 1000 * 1e-6;
}

TEST(InertialMass, of_a_shells_node_includes_the_liquid_beside_the_material) {
    for (const double density : {1100.0, 7800.0, 300.0})
        EXPECT_NEAR(weight_in_water(density, 2e-7), (density - 1000) * 2e-7, 1e-15) << density;
    EXPECT_NEAR(weight_in_water(1100, 1e-6), 1e-4, 1e-15) << "a solid fills the volume of its nodes";
    Part thick = leaflet_of(1100);
    thick.thickness = Value<double>(0.03, SourceLocation{"scene.toml", 2});
    const SceneAndParticles made = one_node_of(thick, 3.3e-3);
    EXPECT_NEAR(node_masses(made.scene, made.particles, 1000)[1], 3.3e-3, 1e-15) << "a thick shell keeps its mass";
}

TEST(InertialMass, of_a_solid_of_springs_weighs_in_the_liquid_what_is_drawn) {
    for (const double volume : {0.92e-6, 1.07e-6})  // of the drawn solid, for a node of 1 cm^3
        EXPECT_NEAR(weight_in_water(1100, volume), 100 * volume, 1e-15) << volume;
    EXPECT_NEAR(weight_in_water(300, 1.07e-6), -700 * 1e-6, 1e-15) << "a light one that of its nodes";
}

TEST(InertialMass, of_a_strips_node_is_at_least_that_of_the_liquid_it_displaces) {
    const auto mass = [](double of_material) {
        const SceneAndParticles made = one_node_of(leaflet_of(0), of_material);
        return node_masses(made.scene, made.particles, 1000)[1];
    };
    EXPECT_NEAR(mass(2e-4), 1e-3, 1e-15);
    EXPECT_EQ(mass(2e-3), 2e-3);
}

TEST(InertialMass, of_a_strips_end_has_half_a_column_of_liquid) {
    // In rows 1 cm apart a strip of 60 kg/m has 3000 kg/m^3.
    const auto mass = [](double of_length, double of_material) {
        Part strip = leaflet_of(0);
        strip.mass_per_length = of_length;
        SceneAndParticles made = one_node_of(strip, of_material);
        made.particles.spacing = 0.01;
        return node_masses(made.scene, made.particles, 1000)[1];
    };
    EXPECT_NEAR(mass(60, 3e-3), 3e-3, 1e-15) << "of three times the liquid's density";
    EXPECT_NEAR(mass(60, 1.5e-3), 2e-3, 1e-15) << "its end: half of it, half of the liquid";
    EXPECT_NEAR(mass(2, 5e-5), 1e-3, 1e-15) << "a light one is as heavy as the liquid";
}

TEST(InertialMass, stays_as_given_where_no_liquid_is_all_around) {
    PairSettings settings;
    settings.density.largest = 1000;
    settings.subtracts_level = false;  // a solid that is wet on one side, or the plain scheme
    EXPECT_EQ(liquid_in_leaflets(settings), 0);
    const SceneAndParticles made = one_node_of(leaflet_of(1100), 2e-4);
    EXPECT_EQ(node_masses(made.scene, made.particles, liquid_in_leaflets(settings)), made.particles.mass);
    settings.subtracts_level = true;
    EXPECT_EQ(liquid_in_leaflets(settings), 1000);
}

}  // namespace
}  // namespace dmp::tests::solver_inertial_mass_tests
