// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Space is divided anew when particles have gathered on some ranks, and only then.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "solver/neighbours/neighbours.hpp"
#include "solver/store/particle_store.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::rebalance_tests {
namespace {

constexpr int columns = 160, rows = 20;

/// Water on a lattice, 16 m by 2 m.
ParticleSet water() {
    ParticleSet set;
    set.dimension = 2;
    set.spacing = 0.1;
    set.box.low = Vec(0, 0, 0);
    set.box.high = Vec(columns * set.spacing, rows * set.spacing, 0);
    set.parts = {{"water", PartKind::fluid}};
    constexpr std::size_t count = columns * rows;
    for (std::size_t i = 0; i < count; ++i)
        set.position.emplace_back((static_cast<double>(i % columns) + 0.5) * set.spacing,
                                  (static_cast<double>(i / columns) + 0.5) * set.spacing, 0);
    set.volume.assign(count, set.spacing * set.spacing);
    set.mass.assign(count, 1000 * set.spacing * set.spacing);
    set.part.assign(count, 0);
    set.body.assign(count, -1);
    set.fixed.assign(count, 0);
    set.seated.assign(count, 0);
    set.wall_normal.assign(count, Vec::Zero());
    set.wall_distance.assign(count, 0);
    return set;
}

/// After lists with some time before each, in which ranks with more to do than others keep those waiting. A division of
/// space follows once they have waited longer than the last one took, which on a busy machine is many lists.
double imbalance_after_a_while(Neighbours& neighbours, ParticleStore& particles) {
    for (int list = 0; list < 3 || (neighbours.imbalance() > 1.001 && list < 200); ++list) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        neighbours.renew(particles);
    }
    return neighbours.imbalance();
}

TEST(Rebalance, follows_water_that_gathers_at_one_end) {
    const Ranks ranks = Ranks::world();
    const ParticleSet set = water();
    ParticleStore particles(set, {1000}, ranks);
    Neighbours neighbours(ranks, particles.space(), 0.3, 1);
    EXPECT_LE(imbalance_after_a_while(neighbours, particles), 1.001);
    // The right half goes in between the columns of the left one: half of the ranks have nothing left to do.
    for (std::size_t i = 0; i < particles.fluid().owned(); ++i) {
        double& x = particles.fluid().data(Field::position, 0)[i];
        if (x > 8) x -= 8.05;
    }
    neighbours.renew(particles);
    if (ranks.size() > 1) {
        EXPECT_GE(neighbours.imbalance(), 1.9);
    }
    EXPECT_LE(imbalance_after_a_while(neighbours, particles), 1.001);
    EXPECT_EQ(ranks.sum(static_cast<std::int64_t>(particles.owned())), columns * rows);
}

}  // namespace
}  // namespace dmp::tests::rebalance_tests
