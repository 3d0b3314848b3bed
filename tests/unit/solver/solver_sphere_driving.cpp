// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Forces on parts of spheres, and moving shapes that they feel.
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "solver/spheres/sphere_run.hpp"
#include "sphere_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_sphere_driving_tests {
namespace {

constexpr double radius = 1e-3;

RunSummary run(const SphereScene& made, int threads = 1) {
    SphereRun engine(made.scene, made.set, Resources(threads));
    return engine.run({});
}

/// Spheres in a row, far apart: `pushed`, and one that is not.
SphereScene row(int pushed) {
    SphereScene made;
    made.scene.run.duration = 0.02;
    made.scene.output.every = 0.0013;
    const int beads = made.part("beads", PartKind::spheres), other = made.part("other", PartKind::spheres);
    made.contact(0.9, 0.1);
    for (int k = 0; k < pushed; ++k) made.sphere(beads, Vec(0, 0.1 * k, 0), radius);
    made.sphere(other, Vec(0, -0.1, 0), radius);
    return made;
}

double mass_of_one(const SphereScene& made) { return made.set.mass.front(); }

TEST(SphereDriving, a_schedules_impulse_is_exact) {
    SphereScene made = row(3);
    ForceOnPart& force = made.force("beads", {"3e-4", "0", "-1e-4"}, ForceAmount::total);
    force.from = given(0.0031);
    force.until = given(0.0049);
    force.period = given(0.0071);
    const RunSummary summary = run(made);
    // Three times in 20 ms: from 3.1, 10.2 and 17.3 ms.
    const double time = 3 * 0.0018;
    EXPECT_NEAR(summary.end.momentum[0], 3e-4 * time, 1e-12 * 3e-4 * time);
    EXPECT_NEAR(summary.end.momentum[2], -1e-4 * time, 1e-12 * 1e-4 * time);
    EXPECT_EQ(summary.end.momentum[1], 0);
    EXPECT_NEAR(summary.impulse_of_body_forces[0], 3e-4 * time, 1e-12 * 3e-4 * time);
    EXPECT_LT(summary.momentum_residual, 1e-12);
}

TEST(SphereDriving, total_is_shared_and_per_particle_is_not) {
    for (const ForceAmount amount : {ForceAmount::total, ForceAmount::per_particle}) {
        SphereScene made = row(4);
        made.force("beads", {"1e-4", "0", "0"}, amount);
        const double on_all = amount == ForceAmount::total ? 1e-4 : 4e-4;
        EXPECT_NEAR(run(made).end.momentum[0], on_all * 0.02, 1e-12 * on_all * 0.02);
    }
}

TEST(SphereDriving, swings_as_its_formula_and_by_place) {
    SphereScene made = row(1);
    // A spring to the plane x = 1 mm, 200 1/s: half a period and a bit.
    const double omega = 200, mass = mass_of_one(made);
    made.force("beads", {std::to_string(mass * omega * omega) + " * (0.001 - x)", "0", "0"}, ForceAmount::per_particle);
    made.scene.output.every = 1e-4;
    SphereRun engine(made.scene, made.set, Resources(1));
    const RunSummary summary = engine.run({});
    const double speed = summary.end.momentum[0] / mass;
    EXPECT_NEAR(speed, 1e-3 * omega * std::sin(omega * 0.02), 2e-3 * 1e-3 * omega);
}

TEST(SphereDriving, a_shape_gives_the_energy_back_that_it_took) {
    SphereScene made = row(1);
    made.set.velocity.front() = Vec(0.1, 0, 0);
    made.circle("beads", {"0.002", "0", "0"}, 1e-3);  // its near side at x = 1 mm
    const RunSummary summary = run(made);
    EXPECT_NEAR(summary.end.momentum[0], -summary.start.momentum[0], 1e-4 * summary.start.momentum[0]);
    EXPECT_NEAR(summary.impulse_of_body_forces[0], -2 * summary.start.momentum[0], 2e-4 * summary.start.momentum[0]);
    EXPECT_THAT(summary.limits, testing::Contains(testing::Field(&StepLimit::model, "driving")));
}

TEST(SphereDriving, crowds_are_the_same_bits_on_any_threads) {
    SphereScene made = crowd(150, 4);
    std::set<std::string> hashes{run(made).state_hash};
    made.circle("large", {"0.002 + t", "0.01", "0"}, 1.7e-3);
    EXPECT_TRUE(hashes.insert(run(made).state_hash).second) << "the shape is felt";
    made.force("small", {"1e-4 * cos(300 * x)", "0", "1e-4 * sin(8000 * t) * z"}, ForceAmount::per_particle).until =
        given(5e-4);
    for (const int threads : {1, 2, 3}) hashes.insert(run(made, threads).state_hash);
    EXPECT_EQ(hashes.size(), 3U) << "with neither, with the shape, with both on any threads";
}

TEST(SphereDriving, what_waits_for_its_push_is_not_still) {
    SphereScene made = row(2);
    made.scene.run.until_steady = 1e-3;
    made.force("beads", {"1e-4", "0", "0"}, ForceAmount::total).from = given(0.01);
    made.scene.forces.back().until = given(0.011);
    const RunSummary summary = run(made);
    EXPECT_GT(summary.simulated_s, 0.011);
    EXPECT_LT(summary.simulated_s, 0.015);
    EXPECT_NEAR(summary.end.momentum[0], 1e-7, 1e-18);
}

TEST(SphereDriving, is_named_among_the_models) {
    SphereScene made = row(1);
    made.force("beads", {"1e-4", "0", "0"}, ForceAmount::total);
    const SphereRun engine(made.scene, made.set, Resources(1));
    EXPECT_THAT(engine.plan().models, testing::Contains(testing::Field(&ModelUse::model, "force on 'beads'")));
}

}  // namespace
}  // namespace dmp::tests::solver_sphere_driving_tests
