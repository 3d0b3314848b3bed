// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "all_pairs.hpp"
#include "solver/sweeps/fluid_passes.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_fluid_passes_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double untouched = 4711;  ///< of copies: passes leave them alone

struct Variant {
    std::string name;
    int dimension;
    WallModel walls;  ///< plain ones carry a density
    bool two_liquids;
    friend void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }
};

/// Equations of state by part: of the crowd's three, and of a second liquid.
std::vector<LiquidState> states_of(const Variant& variant) {
    return {{20, 1000}, {20, 1000}, {20, 1000}, {20, variant.two_liquids ? 800.0 : 1000.0}};
}

/// A crowd in a random state, with two copies of each kind.
ParticleStore particles_of(const Variant& variant) {
    ParticleSet set = crowd(variant.dimension, {true, false, false});
    set.parts.push_back({"oil", PartKind::fluid});
    for (std::size_t i = 0; i < set.size(); i += 3)
        if (variant.two_liquids && set.part[i] == 0) set.part[i] = 3;
    std::vector<double> densities;
    for (const LiquidState& state : states_of(variant)) densities.push_back(state.rest_density);
    ParticleStore particles(set, densities);
    make_pair_sweeps({.spacing = set.spacing,
                      .support = 3 * set.spacing,
                      .sound_speed = 20,
                      .density = {.largest = 1000},
                      .shifting = 4,
                      .walls = {.model = variant.walls}},
                     particles);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (ParticleGroup& group : particles.groups()) {
        group.resize(group.owned(), 2);
        for (const Field field : group.declared())
            for (int axis = 0; axis < group.axes(field); ++axis) {
                double* values = group.data(field, axis);
                std::fill(values + group.owned(), values + group.total(), untouched);
                if (field == Field::position || field == Field::mass) continue;
                for (std::size_t i = 0; i < group.owned(); ++i)
                    values[i] =
                        field == Field::density ? densities[group.tags()[i].part] + 9 * unit(random) : 5 * unit(random);
            }
    }
    return particles;
}

/// Particles, and the same before the pass.
class FluidPassesOn : public testing::TestWithParam<Variant> {
  protected:
    [[nodiscard]] FluidPasses passes(int threads = 2) const { return {states, threads}; }

    /// Calls visit(now, before, i) for the owned particles; checks that copies are what they were.
    template <class Visit>
    void for_each(const Visit& visit) {
        for (ParticleGroup& group : particles.groups()) {
            for (std::size_t i = 0; i < group.owned(); ++i) visit(group, before.of(group.kind()), i);
            for (const Field field : group.declared())
                for (int axis = 0; axis < group.axes(field); ++axis)
                    for (std::size_t i = group.owned(); i < group.total(); ++i)
                        EXPECT_EQ(group.data(field, axis)[i], untouched);
        }
    }

    /// Those fields of a particle that a pass does not write are what they were.
    void expect_kept(const FieldList& fields, const ParticleGroup& now, const ParticleGroup& then, std::size_t i) {
        for (const Field field : fields)
            for (int axis = 0; now.has(field) && axis < now.axes(field); ++axis)
                EXPECT_EQ(now.data(field, axis)[i], then.data(field, axis)[i]) << info(field).name;
    }

    static constexpr double dt = 0.003;
    std::vector<LiquidState> states = states_of(GetParam());
    ParticleStore particles = particles_of(GetParam());
    const ParticleStore before = particles;
};

TEST_P(FluidPassesOn, drift_to_middle) {
    passes().drift_to_middle(particles, dt);
    for_each([&](const ParticleGroup& now, const ParticleGroup& then, std::size_t i) {
        const bool is_fluid = now.kind() == PartKind::fluid;
        for (int axis = 0; axis < now.dimension(); ++axis) {
            const double x = then.data(Field::position, axis)[i];
            const double moved = now.data(Field::position, axis)[i] - x;
            const double expected = is_fluid ? dt * then.data(Field::velocity, axis)[i] : 0;
            EXPECT_NEAR(moved, expected, 0.5 * particles.quantum().size());
            EXPECT_EQ(moved, particles.quantum().round(moved));
        }
        expect_kept({Field::velocity, Field::mass, Field::force, Field::shift, Field::density_rate}, now, then, i);
        EXPECT_EQ(now.has(Field::density), is_fluid || GetParam().walls == WallModel::plain);
        if (!now.has(Field::density)) return expect_kept({Field::volume}, now, then, i);
        const double density = then.data(Field::density)[i] + dt * then.data(Field::density_rate)[i];
        EXPECT_DOUBLE_EQ(now.data(Field::density)[i], density);
        EXPECT_DOUBLE_EQ(now.data(Field::volume)[i], then.data(Field::mass)[i] / density);
        // From the density that is there: pressure is steep.
        const double pressure = states[now.tags()[i].part].pressure(now.data(Field::density)[i]);
        EXPECT_NEAR(now.data(Field::pressure)[i], pressure, 1e-9);
        EXPECT_NE(pressure, 0);
    });
}

TEST_P(FluidPassesOn, update_pressure) {
    passes().update_pressure(particles);
    for_each([&](const ParticleGroup& now, const ParticleGroup& then, std::size_t i) {
        expect_kept({Field::position, Field::velocity, Field::density}, now, then, i);
        if (!now.has(Field::density)) return;
        const double density = then.data(Field::density)[i];
        EXPECT_NEAR(now.data(Field::pressure)[i], states[now.tags()[i].part].pressure(density), 1e-9);
        EXPECT_DOUBLE_EQ(now.data(Field::volume)[i], then.data(Field::mass)[i] / density);
    });
}

TEST_P(FluidPassesOn, kick) {
    const std::array<double, 3> g{0.4, -9.81, 3};
    const double fastest = passes().kick(particles.fluid(), dt, g).largest;
    double expected_fastest = 0;
    for_each([&](const ParticleGroup& now, const ParticleGroup& then, std::size_t i) {
        const bool is_fluid = now.kind() == PartKind::fluid;
        expect_kept({Field::position, Field::density, Field::force, Field::mass}, now, then, i);
        double square = 0;
        for (int axis = 0; axis < now.dimension(); ++axis) {
            const double v = now.data(Field::velocity, axis)[i], force = then.data(Field::force, axis)[i];
            const double kick = is_fluid ? dt * (force / then.data(Field::mass)[i] + g[axis]) : 0;
            EXPECT_NEAR(v, then.data(Field::velocity, axis)[i] + kick, 1e-14);
            square += v * v;
        }
        if (is_fluid) expected_fastest = std::max(expected_fastest, std::sqrt(square));
    });
    EXPECT_DOUBLE_EQ(fastest, expected_fastest);
}

TEST_P(FluidPassesOn, note_transport_is_the_way_of_the_shift_over_the_step) {
    particles.fluid().declare({Field::transport_velocity});
    const ShiftStep shift{-4e-4, 1.5e-3};
    passes().note_transport(particles.fluid(), dt, shift);
    int cut = 0;
    for (std::size_t i = 0; i < particles.fluid().owned(); ++i) {
        Vec way = Vec::Zero(), noted = Vec::Zero();
        for (int axis = 0; axis < particles.dimension(); ++axis) {
            way[axis] = shift.per_sum * before.fluid().data(Field::shift, axis)[i];
            noted[axis] = particles.fluid().data(Field::transport_velocity, axis)[i];
        }
        if (way.norm() > shift.longest) {
            way *= shift.longest / way.norm();
            ++cut;
        }
        EXPECT_LT((dt * noted - way).norm(), 1e-14 * way.norm());
    }
    EXPECT_GT(cut, 0);
}

TEST_P(FluidPassesOn, drift_to_end_with_shifting) {
    const ShiftStep shift{-4e-4, 1.5e-3};  // sums are up to 5 long an axis: some are cut
    const PassExtremes extremes = passes().drift_to_end(particles, dt, shift);
    int cut = 0, whole = 0;
    double longest = 0;
    for_each([&](const ParticleGroup& now, const ParticleGroup& then, std::size_t i) {
        expect_kept({Field::velocity, Field::pressure, Field::volume, Field::force, Field::shift}, now, then, i);
        if (now.has(Field::density)) {
            const double density = then.data(Field::density)[i] + dt * then.data(Field::density_rate)[i];
            EXPECT_DOUBLE_EQ(now.data(Field::density)[i], density);
        }
        if (now.kind() != PartKind::fluid) return expect_kept({Field::position}, now, then, i);
        Vec way = Vec::Zero();
        for (int axis = 0; axis < now.dimension(); ++axis) way[axis] = shift.per_sum * then.data(Field::shift, axis)[i];
        const double length = way.norm();
        ++(length > shift.longest ? cut : whole);
        if (length > shift.longest) way *= shift.longest / length;
        longest = std::max(longest, way.norm());
        for (int axis = 0; axis < now.dimension(); ++axis) {
            const double moved = now.data(Field::position, axis)[i] - then.data(Field::position, axis)[i];
            EXPECT_NEAR(moved, dt * then.data(Field::velocity, axis)[i] + way[axis], particles.quantum().size());
            EXPECT_EQ(moved, particles.quantum().round(moved));
        }
    });
    EXPECT_GT(cut, 10);
    EXPECT_GT(whole, 10);
    EXPECT_DOUBLE_EQ(extremes.longest_shift, longest);
    const PassExtremes after = passes().extremes(particles.fluid());
    EXPECT_EQ(extremes.density_low, after.density_low);
    EXPECT_EQ(extremes.density_high, after.density_high);
}

TEST_P(FluidPassesOn, drift_to_end_without_shifting) {
    EXPECT_EQ(passes().drift_to_end(particles, dt, {}).longest_shift, 0);
    for_each([&](const ParticleGroup& now, const ParticleGroup& then, std::size_t i) {
        if (now.kind() != PartKind::fluid) return;
        for (int axis = 0; axis < now.dimension(); ++axis) {
            const double moved = now.data(Field::position, axis)[i] - then.data(Field::position, axis)[i];
            EXPECT_NEAR(moved, dt * then.data(Field::velocity, axis)[i], 0.5 * particles.quantum().size());
        }
    });
}

TEST_P(FluidPassesOn, extremes) {
    const ParticleGroup& fluid = particles.fluid();
    double fastest = 0, low = infinity, high = 0;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        double square = 0;
        for (int axis = 0; axis < fluid.dimension(); ++axis)
            square += fluid.data(Field::velocity, axis)[i] * fluid.data(Field::velocity, axis)[i];
        fastest = std::max(fastest, std::sqrt(square));
        const double relative = fluid.data(Field::density)[i] / states[fluid.tags()[i].part].rest_density;
        low = std::min(low, relative);
        high = std::max(high, relative);
    }
    const PassExtremes found = passes().extremes(fluid);
    EXPECT_DOUBLE_EQ(found.largest_speed, fastest);
    EXPECT_DOUBLE_EQ(found.density_low, low);
    EXPECT_DOUBLE_EQ(found.density_high, high);
    EXPECT_GT(low, 0.98);
    EXPECT_LT(high, 1.02);
}

TEST_P(FluidPassesOn, fourth_powers_of_speeds_are_the_same_bits_in_any_order) {
    ParticleGroup& fluid = particles.fluid();
    double plain = 0;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        double square = 0;
        for (int axis = 0; axis < fluid.dimension(); ++axis)
            square += std::pow(fluid.data(Field::velocity, axis)[i], 2);
        plain += square * square;
    }
    const double largest = passes().extremes(fluid).largest_speed;
    const double sum = passes(1).fourth_powers_of_speeds(fluid, largest).value();
    EXPECT_NEAR(sum, plain, 1e-11 * plain);
    for (int axis = 0; axis < fluid.dimension(); ++axis) {
        double* v = fluid.data(Field::velocity, axis);
        std::reverse(v, v + fluid.owned());
    }
    for (const int threads : {1, 2, 3}) EXPECT_EQ(passes(threads).fourth_powers_of_speeds(fluid, largest).value(), sum);
    for (const double broken : {infinity, 1e100})
        EXPECT_EQ(passes().fourth_powers_of_speeds(fluid, broken).value(), infinity);
}

TEST_P(FluidPassesOn, kick_sums_the_fourth_powers_of_speeds_on_the_way) {
    const double none = passes().kick(particles.fluid(), dt, {}).fourth_powers.value();
    EXPECT_EQ(none, 0);
    for (const int threads : {1, 2, 3}) {
        particles = before;
        SpeedSums speeds = passes().kick(particles.fluid(), dt, {}, 1);
        const double expected = passes().fourth_powers_of_speeds(particles.fluid(), speeds.largest).value();
        EXPECT_NEAR(speeds.fourth_powers.value(), expected, 1e-9 * expected);
        particles = before;
        speeds = passes(threads).kick(particles.fluid(), dt, {}, speeds.largest);
        EXPECT_EQ(speeds.fourth_powers.value(), expected);
    }
}

TEST(FluidPasses, sums_of_fourth_powers_are_alike_within_a_binade) {
    EXPECT_TRUE(FluidPasses::sum_alike(1, 1.15));  // fourth powers from 1 to 2
    EXPECT_FALSE(FluidPasses::sum_alike(1, 1.2));
    EXPECT_FALSE(FluidPasses::sum_alike(1, 0.99));
    EXPECT_FALSE(FluidPasses::sum_alike(0, 0));
    for (const double broken : {infinity, 1e100}) EXPECT_FALSE(FluidPasses::sum_alike(broken, broken));
}

TEST_P(FluidPassesOn, velocity_that_is_no_number_is_an_infinite_largest_speed) {
    ParticleGroup& fluid = particles.fluid();
    const std::size_t last = fluid.owned() - 1;
    for (const double bad : {not_a_number, infinity, -infinity, 1e200})
        for (const std::size_t i : {std::size_t{0}, last / 2, last})
            for (const int threads : {1, 3}) {
                particles = before;
                fluid.data(Field::velocity, 1)[i] = bad;
                EXPECT_EQ(passes(threads).extremes(fluid).largest_speed, infinity);
                EXPECT_EQ(passes(threads).kick(fluid, dt, {}).largest, infinity);
                particles = before;
                fluid.data(Field::force, 0)[i] = bad;
                EXPECT_EQ(passes(threads).kick(fluid, dt, {}).largest, infinity);
            }
    particles = before;
    EXPECT_LT(passes().kick(fluid, dt, {}).largest, infinity);
}

INSTANTIATE_TEST_SUITE_P(Variants, FluidPassesOn,
                         testing::Values(Variant{"2d", 2, WallModel::extrapolated, false},
                                         Variant{"2d_plain_walls_two_liquids", 2, WallModel::plain, true},
                                         Variant{"3d_two_liquids", 3, WallModel::extrapolated, true},
                                         Variant{"3d_plain_walls", 3, WallModel::plain, false}),
                         [](const auto& variant) { return variant.param.name; });

/// What velocities interpolated anew add to the momentum, by particles in their order or in the reverse one.
std::array<double, 3> momentum_of_shift(bool reversed, double largest_momentum) {
    ParticleStore particles(crowd(2, {true, false, false}), {1000, 1000, 1000});
    ParticleGroup& fluid = particles.fluid();
    make_pair_sweeps({.spacing = particles.space().spacing,
                      .support = 3 * particles.space().spacing,
                      .sound_speed = 20,
                      .corrected = true,
                      .density = {.largest = 1000},
                      .shifting = 0.2},
                     particles);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const std::size_t count = fluid.owned();
    for (const Field field : {Field::velocity, Field::velocity_gradient, Field::shift, Field::off_walls,
                              Field::next_density_gradient, Field::density})
        for (int axis = 0; axis < fluid.axes(field); ++axis)
            for (std::size_t i = 0; i < count; ++i)
                // From 1e-6 to 1, so that most of the bits of a sum depend on its order.
                fluid.data(field, axis)[reversed ? count - 1 - i : i] =
                    unit(random) * std::pow(10, 3 * unit(random) - 3);
    std::fill_n(fluid.data(Field::mass), count, 0.3);
    auto shifted = FluidPasses({{20, 1000}, {20, 1000}, {20, 1000}}, 1)
                       .shift(particles, 1e-3, {.per_sum = 1e-3, .longest = 1e-2}, largest_momentum, 0);
    return {shifted.momentum[0].value(), shifted.momentum[1].value(), shifted.momentum[2].value()};
}

TEST(FluidPasses, momentum_of_a_shift_is_the_same_bits_in_any_order) {
    for (const double largest : {1e-3, 1e-5, 1e-12, 0.0}) {  // terms are 6e-4 at most
        const auto momentum = momentum_of_shift(false, largest);
        EXPECT_NE(momentum[0], 0) << largest;
        EXPECT_EQ(momentum, momentum_of_shift(true, largest)) << largest;
    }
}

/// Sums over particles in their order or in the reverse one, of pressures of up to 0.4 rho c0^2.
VolumeSums volume_sums_of(bool reversed) {
    ParticleStore particles(crowd(2, {true, false, false}), {1000, 1000, 1000});
    ParticleGroup& fluid = particles.fluid();
    make_pair_sweeps({.spacing = 0.1,
                      .support = 0.3,
                      .sound_speed = 20,
                      .corrected = true,
                      .subtracts_level = true,
                      .density = {.largest = 1000}},
                     particles);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const std::array<double, 5> corrections{1.02, 1.36, 1, std::numeric_limits<double>::quiet_NaN(), 1.34};
    const std::size_t count = fluid.owned();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = reversed ? count - 1 - k : k;
        fluid.data(Field::volume)[i] = 0.01 * (1 + 0.3 * unit(random));
        fluid.data(Field::reduced_pressure)[i] = 0.4 * 1000 * 400 * unit(random);
        fluid.data(Field::mean_correction)[i] = corrections.at(k % 5);
    }
    return FluidPasses({{20, 1000}, {20, 1000}, {20, 1000}}, 1).volume_sums(fluid, 0.02, 0.1 * 1000 * 400);
}

TEST(FluidPasses, sums_over_volumes_are_the_same_bits_in_any_order) {
    VolumeSums sums = volume_sums_of(false), reversed = volume_sums_of(true);
    EXPECT_GT(sums.volume.value(), 1);
    EXPECT_EQ(sums.volume.value(), reversed.volume.value());
    EXPECT_EQ(sums.pressure.value(), reversed.pressure.value());
    EXPECT_EQ(sums.square.value(), reversed.square.value());
    // Of a uniform distribution from -a to a: a^2 / 3.
    EXPECT_NEAR(sums.square.value() / sums.volume.value(), std::pow(0.4 * 1000 * 400, 2) / 3, 2e9);
    const double count = sums.beside_voids.value(), particles = sums.volume.value() / 0.01;
    EXPECT_NEAR(count, 0.4 * particles, 0.05 * particles) << "1.36 and 1 of the five";
    EXPECT_EQ(count, reversed.beside_voids.value());
}

TEST(FluidPasses, of_no_fluid_have_no_speed) {
    ParticleSet set;
    set.spacing = 0.1;
    ParticleStore particles(set, {});
    make_pair_sweeps({.spacing = 0.1, .support = 0.3, .sound_speed = 20, .density = {.largest = 1000}}, particles);
    const FluidPasses passes({}, 2);
    EXPECT_EQ(passes.kick(particles.fluid(), 0.1, {}, 1).largest, 0);
    EXPECT_EQ(passes.extremes(particles.fluid()).largest_speed, 0);
    EXPECT_EQ(passes.fourth_powers_of_speeds(particles.fluid(), 0).value(), 0);
}

}  // namespace
}  // namespace dmp::tests::solver_fluid_passes_tests
