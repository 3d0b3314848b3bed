// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The volume that the fluid keeps, and the level and slope of the pressure that is subtracted.
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "all_pairs.hpp"
#include "solver/time/fluid_reference.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_fluid_reference_tests {
namespace {

const std::vector<double> rest_densities{1000, 1000, 1000};
constexpr double dt = 1e-3, void_time = 0.01;  // [s]

ParticleStore particles() { return {crowd(2, {true, false, false}), rest_densities}; }

VolumeSums sums(double volume, double pressure) {
    VolumeSums made;
    made.volume.add(volume);
    made.pressure.add(volume * pressure);
    return made;
}

FluidReference reference_of(const ParticleStore& store, bool subtracts, bool keeps_volume) {
    return {{subtracts, keeps_volume, void_time}, rest_densities, store, Ranks::alone()};
}

TEST(FluidReference, finds_by_what_share_the_densities_are_too_high) {
    FluidReference reference = reference_of(particles(), true, true);
    EXPECT_EQ(reference.density_excess(), 0);
    reference.start(sums(2, 0));
    reference.update(sums(1.6, 0), dt);
    EXPECT_DOUBLE_EQ(reference.density_excess(), 0.25);
    reference.update(sums(2.5, 0), dt);
    EXPECT_DOUBLE_EQ(reference.density_excess(), -0.2);
    EXPECT_NEAR(reference.density_drift(), 0.05, 1e-15);
}

TEST(FluidReference, leaves_a_volume_alone_that_walls_may_change) {
    FluidReference reference = reference_of(particles(), true, false);
    reference.start(sums(2, 0));
    reference.update(sums(1.6, 0), dt);
    EXPECT_EQ(reference.density_excess(), 0);
    EXPECT_EQ(reference.density_drift(), 0);
}

TEST(FluidReference, allows_for_liquid_that_turned_solid) {
    ParticleStore store = particles();
    FluidReference reference = reference_of(store, true, true);
    reference.start(sums(2, 0));
    const double mass = reference.mass();
    for (std::size_t i = 0; i < store.fluid().owned(); ++i) store.fluid().data(Field::mass)[i] /= 2;
    reference.count(store, Ranks::alone());
    EXPECT_DOUBLE_EQ(reference.mass(), mass / 2);
    reference.update(sums(1, 0), dt);
    EXPECT_NEAR(reference.density_excess(), 0, 1e-14);
}

TEST(FluidReference, adds_up_the_level_and_has_the_hydrostatic_slope) {
    const ParticleStore store = particles();
    FluidReference reference = reference_of(store, true, true);
    reference.start(sums(2, 30));
    reference.update(sums(2, -10), dt);
    const std::array<double, 3> g{0, -9.81, 0};
    EXPECT_DOUBLE_EQ(reference.pressure(store, g).level, 20);
    EXPECT_NEAR(reference.pressure(store, g).slope[1], -9810, 1e-8);
    EXPECT_EQ(reference.pressure(store, g).slope[0], 0);
}

/// Half of the volume is at `pressure`, half at minus that.
VolumeSums with_voids(double pressure, int particles) {
    VolumeSums made = sums(2, 0);
    made.square.add(2 * pressure * pressure);
    made.beside_voids.add(particles);
    return made;
}

TEST(FluidReference, is_less_than_the_level_while_there_is_a_void) {
    const ParticleStore store = particles();
    FluidReference reference = reference_of(store, true, true);
    const auto subtracted = [&] { return reference.pressure(store, {}).level; };
    reference.start(sums(2, 30));
    reference.update(with_voids(20, 2), dt);
    EXPECT_DOUBLE_EQ(subtracted(), 30) << "two particles are no void";
    reference.update(with_voids(20, 3), dt);
    EXPECT_DOUBLE_EQ(subtracted(), 30 - 0.1 * 60) << "a tenth of the time, of three times the deviation";
    for (int step = 0; step < 200; ++step) {
        VolumeSums now = sums(2, 30 - subtracted());  // what is subtracted is not in the pressures
        now.square.add(2 * (400 + (30 - subtracted()) * (30 - subtracted())));
        now.beside_voids.add(3);
        reference.update(now, dt);
    }
    EXPECT_NEAR(subtracted(), 30 - 60, 1e-6) << "the level stays";
    for (int step = 0; step < 200; ++step) {
        VolumeSums now = sums(2, 30 - subtracted());
        now.square.add(2 * (400 + (30 - subtracted()) * (30 - subtracted())));
        reference.update(now, dt);
    }
    EXPECT_DOUBLE_EQ(subtracted(), 30) << "once it is closed";
    EXPECT_EQ(reference.suction(), 0);
}

TEST(FluidReference, is_nothing_where_no_level_is_subtracted_or_all_is_solid) {
    ParticleStore store = particles();
    FluidReference reference = reference_of(store, false, true);
    reference.start(sums(2, 30));
    const std::array<double, 3> g{0, -9.81, 0};
    EXPECT_EQ(reference.pressure(store, g).level, 0);
    EXPECT_EQ(reference.pressure(store, g).slope[1], 0);

    FluidReference solid = reference_of(store, true, true);
    solid.start(sums(2, 30));
    for (std::size_t i = 0; i < store.fluid().owned(); ++i) store.fluid().data(Field::mass)[i] = 0;
    solid.count(store, Ranks::alone());
    solid.update(sums(2, 0), dt);
    EXPECT_EQ(solid.pressure(store, g).level, 0);
    EXPECT_EQ(solid.pressure(store, g).slope[1], 0);
    EXPECT_EQ(solid.density_excess(), 0);
}

TEST(FluidReference, warns_of_a_drift_beyond_five_percent) {
    EXPECT_FALSE(drift_warning(0.049));
    ASSERT_TRUE(drift_warning(-0.3));
    EXPECT_NE(drift_warning(-0.3)->problem.find("a drift of its mean density of -30 %"), std::string::npos);
}

}  // namespace
}  // namespace dmp::tests::solver_fluid_reference_tests
