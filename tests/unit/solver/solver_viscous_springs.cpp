// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Light, stiff spring bodies in a very viscous liquid, whose viscosity is implicit.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_viscous_springs_tests {
namespace {

constexpr double stretch = 0.002, rest_length = 0.1;

/// A stretched rod in a liquid of 20 kPa s, which it can only creep through: without inertia it would lose its stretch
/// within about 0.1 s; in a vacuum it would swing 1e2 to 1e5 times in that time. A fluid particle weighs 10 kg.
SceneAndParticles stretched_rod(double node_mass) {
    SceneAndParticles made = endless_water();
    made.scene.parts[0].viscosity = 2e4;
    made.scene.numerics.viscosity_stepping = ViscosityStepping::implicitly;
    made.scene.numerics.sound_speed = 10.0;  // "auto" is faster with explicit viscosity
    made.scene.contact.range = 0.0;
    made.scene.run.duration = 0.1;
    made.scene.output.every = 0.05;
    add_flags(made);
    add_rod(made, Vec(0.4, 0.35, 0), 0);
    ParticleSet& set = made.particles;
    set.position.back()[1] += stretch;
    set.mass[set.size() - 2] = set.mass.back() = node_mass;
    set.bonds.back().stiffness = 1.2e5;
    return made;
}

struct Creep {
    double left = 0;  ///< of the stretch, in the end
    RunSummary summary;
};

Creep creep_of(const SceneAndParticles& made, const Resources& resources = 1) {
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    Creep creep;
    creep.summary = Simulation(made.scene, made.particles, resources).run(options);
    const FrameGroup& rod = *group_of(kept.frames.back(), "solid");
    const double length = std::hypot(rod.position[3] - rod.position[0], rod.position[4] - rod.position[1]);
    creep.left = (length - rest_length) / stretch;
    return creep;
}

TEST(ViscousSprings, creep_as_with_explicit_viscosity_and_a_step_hundreds_of_times_shorter) {
    SceneAndParticles explicitly = stretched_rod(1);
    explicitly.scene.numerics.viscosity_stepping = ViscosityStepping::explicitly;
    explicitly.scene.numerics.step_factor = 5e-4;
    const Creep expected = creep_of(explicitly), found = creep_of(stretched_rod(1));
    EXPECT_GT(expected.summary.steps, 200 * found.summary.steps);
    EXPECT_GT(expected.left, 0.1);
    EXPECT_LT(expected.left, 0.9);
    EXPECT_NEAR(found.left, expected.left, 0.05);
    SceneAndParticles finer = stretched_rod(1);
    finer.scene.numerics.step_factor = 0.3 / 8;
    EXPECT_NEAR(creep_of(finer).left, expected.left, 0.05 / 4);
    EXPECT_LT(found.summary.momentum_residual, 1e-12);
}

TEST(ViscousSprings, creep_alike_however_light_they_are) {
    const double heavy = creep_of(stretched_rod(1)).left;
    for (const double mass : {1e-2, 1e-4, 1e-6}) {
        const Creep light = creep_of(stretched_rod(mass));
        EXPECT_NEAR(light.left, heavy, 0.02) << mass << " kg";
        EXPECT_LT(light.summary.viscous_solves.most_iterations, 200) << mass << " kg";
    }
}

TEST(ViscousSprings, creep_with_the_same_bits_on_any_threads) {
    const SceneAndParticles made = stretched_rod(1e-3);
    EXPECT_EQ(creep_of(made, 2).summary.state_hash, creep_of(made, 1).summary.state_hash);
}

}  // namespace
}  // namespace dmp::tests::solver_viscous_springs_tests
