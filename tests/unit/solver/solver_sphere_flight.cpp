// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "solver/spheres/quad.hpp"
#include "solver/spheres/sphere_group.hpp"
#include "solver/spheres/sphere_run.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/sphere_scenes.hpp"

namespace dmp::tests::solver_sphere_flight_tests {
namespace {

/// A crowd, or one in which a gravity that happens to be 0 keeps every sphere under a step's eyes.
SphereScene crowd_seen_from(bool always) {
    SphereScene made = crowd(150, 4);
    made.sphere(0, {0.5e-3, 0.5e-3, 0.2}, 0.1e-3, {-0.0, 1, -0.0}, {-0.0, 0, 0});  // meets nobody
    if (always) made.scene.flow.acceleration[0] = SphereScene::expression("0 * t");
    return made;
}

std::string hash_of(const SphereScene& made, int threads) {
    return SphereRun(made.scene, made.set, Resources(threads)).run({}).state_hash;
}

TEST(SphereFlight, spheres_go_as_far_as_if_each_step_had_looked_at_them) {
    std::set<std::string> hashes;
    for (const bool always : {true, false})
        for (const int threads : {1, 3}) hashes.insert(hash_of(crowd_seen_from(always), threads));
    EXPECT_EQ(hashes.size(), 1U);
}

TEST(SphereFlight, takes_those_that_nothing_acts_on) {
    const auto share_flying = [](SphereScene made) {
        SphereSetup setup = sphere_setup(made.scene, made.set);
        ParticleGroup group = sphere_group(made.set, PositionQuantum(made.set), Ranks::alone());
        SphereStep step(made.scene, made.set, made.set, group, setup, Resources(1));
        step.start(true, 0);
        double sum = 0;
        for (int k = 0; k < 200; ++k) {
            step.advance(k * 1e-6, 1e-6);
            const FreeFlight& flight = step.rows().flight();
            EXPECT_EQ(flight.busy().size() + flight.flying().size(), made.set.size());
            for (const std::int32_t row : flight.flying()) {
                const double* force = step.rows().loads()[static_cast<std::size_t>(row)].force.c;
                EXPECT_EQ(force[0] * force[0] + force[1] * force[1] + force[2] * force[2], 0);
            }
            sum += static_cast<double>(flight.flying().size());
        }
        return sum / 200 / static_cast<double>(made.set.size());
    };
    EXPECT_GT(share_flying(crowd_seen_from(false)), 0.5);
    EXPECT_EQ(share_flying(crowd_seen_from(true)), 0);
    SphereScene pushed = crowd_seen_from(false);
    pushed.force("small", {"1e-4", "0", "0"}, ForceAmount::per_particle);
    pushed.force("large", {"1e-4", "0", "0"}, ForceAmount::per_particle);
    EXPECT_EQ(share_flying(pushed), 0);
}

/// In 3-D of 1 m around 0: two spheres, one of them so far out that places there are coarser than quanta.
TEST(SphereFlight, many_steps_are_the_same_bits_as_one_after_the_other) {
    ParticleSet space;
    space.dimension = 3;
    space.box = {Vec::Constant(-0.5), Vec::Constant(0.5)};
    const PositionQuantum quantum(space);
    for (const int threads : {1, 2}) {
        std::vector<SphereMotion> once(3), each(3);
        once[0].position = {{0.1, -0.2, 0.3, 1}};
        once[0].velocity = {{1 / 3.0, -7 / 9.0, 1e-9, 1}};
        once[1].position = {{quantum.round(123 / 7.0), -40, 0, 1}};
        once[1].velocity = {{11 / 7.0, -2 / 3.0, 5 / 3.0, 1}};
        once[2] = once[0];
        each = once;
        FreeFlight flight(threads);
        flight.begin(std::vector<std::uint8_t>{0, 0, 1});
        for (const double dt : {1e-4, 3e-4})
            for (int k = 0; k < 1000; ++k) {
                flight.pass(dt, quantum, once);
                for (std::size_t i = 0; i < 2; ++i)
                    write(each[i].position,
                          read(each[i].position) + way_of(read(each[i].velocity), dt, quantum.magic()));
            }
        EXPECT_NE(once[0].position.c[0], each[0].position.c[0])
            << "it has been brought to the end of the shorter steps";
        flight.land(once);
        for (std::size_t i = 0; i < 3; ++i)
            for (int c = 0; c < 4; ++c) EXPECT_EQ(once[i].position.c[c], each[i].position.c[c]) << i << ' ' << c;
        EXPECT_NEAR(once[0].position.c[0], 0.1 + 0.4 / 3, 1e-9);
        EXPECT_EQ(once[2].position.c[0], 0.1);
        flight.land(once);
        EXPECT_EQ(once[0].position.c[0], each[0].position.c[0]) << "there already";
    }
}

}  // namespace
}  // namespace dmp::tests::solver_sphere_flight_tests
