// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The operator of implicit viscosity: the viscous force as a linear function of velocities.
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "arranged_crowd.hpp"
#include "base/simd/lanes.hpp"
#include "models/sph/kernels.hpp"
#include "models/sph/viscous_laws.hpp"
#include "models/sph/walls.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_viscous_sweep_tests {
namespace {

/// Viscous forces on all particles of the velocities in `field`, one pair after another in plain numbers.
template <int D, class Solid, class Law>
std::vector<Vec> by_all_pairs(ParticleStore& particles, const ParticleSet& set, const PairSettings& settings,
                              const Solid& solid, const Law& law) {
    const WendlandC2<D> kernel(settings.support);
    const ById by_id(particles);
    std::vector<Vec> force(set.size(), Vec::Zero());
    for_all_pairs(particles, settings.support, [&](const Meeting& m) {
        if (set.kind(m.i) != PartKind::fluid || never_meet(set, m.i, m.j)) return;
        Vector<double, D> separation;
        for (int axis = 0; axis < D; ++axis) separation[axis] = m.separation[axis];
        const double r = m.separation.norm();
        const auto i = FluidReader<Lanes, D>(by_id.group(m.i))(by_id.index(m.i));
        const auto add = [&](const auto& j, bool reacts) {
            const auto f = law.law(Pair{i, j, separation, r, kernel.slope(r)});
            for (int axis = 0; axis < D; ++axis) {
                force[m.i][axis] += f[axis];
                if (reacts) force[m.j][axis] -= f[axis];
            }
        };
        if (set.kind(m.j) == PartKind::fluid) {
            add(FluidReader<Lanes, D>(by_id.group(m.j))(by_id.index(m.j)), false);
        } else if (set.kind(m.j) == PartKind::rigid) {
            const SolidReader<Lanes, D, Solid::needs_state, Solid::needs_surface> read(by_id.group(m.j));
            add(solid.rigid(i, read(by_id.index(m.j)), separation), true);
        } else {
            const SolidReader<Lanes, D, Solid::needs_state, false> read(by_id.group(m.j));
            add(solid.springs(i, read(by_id.index(m.j)), separation), true);
        }
    });
    return force;
}

template <int D, class Law>
std::vector<Vec> by_all_pairs(ParticleStore& particles, const ParticleSet& set, const PairSettings& settings,
                              const Law& law) {
    if (settings.walls.model == WallModel::plain)
        return by_all_pairs<D>(particles, set, settings, PlainSolid<D>{}, law);
    const ExtrapolatedSolid<D> solid{Vector<double, D>::zero(), 0.5 * settings.spacing};
    return by_all_pairs<D>(particles, set, settings, solid, law);
}

template <int D>
std::vector<Vec> by_all_pairs(ParticleStore& particles, const ParticleSet& set, const PairSettings& settings) {
    const ViscousScales scales = viscous_scales(D, settings.spacing, settings.support,
                                                [&](double r) { return WendlandC2<D>(settings.support).slope(r); });
    const bool arithmetic = settings.viscosity.mean == ViscosityMean::arithmetic;
    return by_all_pairs<D>(particles, set, settings, AnyViscousTerm(settings.viscosity.law, scales, arithmetic));
}

struct LawWithMean {
    ViscousLaw law;
    ViscosityMean mean = ViscosityMean::harmonic;
};

using Variant = std::tuple<int, LawWithMean, WallModel>;

class ViscousSweepOf : public testing::TestWithParam<Variant> {
  protected:
    ViscousSweepOf()
        : set(crowd(std::get<int>(GetParam()), {true, false, std::get<int>(GetParam()) == 3}, 3)),
          settings(crowd_settings(set, false, std::get<WallModel>(GetParam()))) {
        settings.viscosity.law = std::get<LawWithMean>(GetParam()).law;
        settings.viscosity.mean = std::get<LawWithMean>(GetParam()).mean;
        settings.viscosity.unlike = true;
        settings.viscosity.implicit = true;
    }

    /// Largest term of a pair, about.
    [[nodiscard]] double largest_term(const PairSweeps& sweeps) const {
        const double volume = std::pow(set.spacing, set.dimension);
        return -4 * settings.viscosity.largest * volume * volume * sweeps.kernel_slope(0.5 * set.spacing);
    }
    /// Puts a random vector of every fluid particle and node, the same for a seed, into a field.
    void shake(ArrangedCrowd& arranged, Field field, unsigned seed) const {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(-1, 1);
        const ById by_id(arranged.particles());
        for (std::size_t id = 0; id < by_id.size(); ++id)
            for (int axis = 0; axis < set.dimension; ++axis) {
                const double value = unit(random);
                if (by_id.group(id).has(field)) by_id.value(field, id, axis) = value;
            }
        arranged.exchange({field});
    }
    /// SUM a . b over fluid particles and nodes.
    static double product(ArrangedCrowd& arranged, Field a, Field b) {
        const ById by_id(arranged.particles());
        double sum = 0;
        for (std::size_t id = 0; id < by_id.size(); ++id)
            if (by_id.group(id).has(a) && by_id.group(id).has(b)) sum += by_id.vector(a, id).dot(by_id.vector(b, id));
        return sum;
    }

    ParticleSet set;
    PairSettings settings;
};

TEST_P(ViscousSweepOf, forces_are_those_of_all_pairs) {
    for (const VectorUnit unit : available_vector_units()) {
        SCOPED_TRACE(to_string(unit));
        ArrangedCrowd arranged(set, settings, {.vector_unit = unit});
        ParticleStore& particles = arranged.particles();
        arranged.sweeps().viscous_forces(particles, arranged.list(),
                                         {Field::velocity, 1, largest_term(arranged.sweeps())});
        const auto expected =
            set.dimension == 3 ? by_all_pairs<3>(particles, set, settings) : by_all_pairs<2>(particles, set, settings);
        const ById by_id(particles);
        double largest = 0;
        for (std::size_t id = 0; id < set.size(); ++id) largest = std::max(largest, expected[id].norm());
        EXPECT_GT(largest, 0);
        Vec sum = Vec::Zero();
        for (std::size_t id = 0; id < set.size(); ++id) {
            EXPECT_LT((by_id.vector(Field::viscous_force, id) - expected[id]).norm(), 1e-12 * largest) << id;
            sum += by_id.vector(Field::viscous_force, id);
        }
        EXPECT_EQ(sum, Vec(Vec::Zero())) << "pair forces cancel to the last bit";
    }
}

TEST_P(ViscousSweepOf, operator_is_symmetric_and_negative) {
    ArrangedCrowd arranged(set, settings, {});
    const double term = largest_term(arranged.sweeps());
    shake(arranged, Field::viscous_velocity, 5);
    shake(arranged, Field::viscous_direction, 6);
    const auto force_of = [&](Field field) {
        arranged.sweeps().viscous_forces(arranged.particles(), arranged.list(), {field, 0, term});
    };
    force_of(Field::viscous_velocity);
    const double there = product(arranged, Field::viscous_direction, Field::viscous_force);
    EXPECT_LT(product(arranged, Field::viscous_velocity, Field::viscous_force), 0);
    force_of(Field::viscous_direction);
    const double back = product(arranged, Field::viscous_velocity, Field::viscous_force);
    const double size = product(arranged, Field::viscous_direction, Field::viscous_force);
    EXPECT_LT(size, 0);
    EXPECT_NEAR(there, back, 1e-12 * std::abs(size));
    EXPECT_GT(std::abs(there), 1e-6 * std::abs(size)) << "not symmetric because all is zero";
}

TEST_P(ViscousSweepOf, diagonal_is_what_a_particles_own_velocity_costs) {
    ArrangedCrowd arranged(set, settings, {});
    const double term = largest_term(arranged.sweeps());
    arranged.sweeps().viscous_diagonal(arranged.particles(), arranged.list());
    const ById by_id(arranged.particles());
    std::size_t camera_of = 0;
    for (std::size_t id = 0; id < set.size(); id += 37) {
        if (set.kind(id) == PartKind::rigid) continue;
        for (int axis = 0; axis < set.dimension; ++axis) {
            by_id.value(Field::viscous_velocity, id, axis) = 1;
            arranged.exchange({Field::viscous_velocity});
            arranged.sweeps().viscous_forces(arranged.particles(), arranged.list(), {Field::viscous_velocity, 0, term});
            const double diagonal = by_id.value(Field::viscous_diagonal, id, axis);
            EXPECT_GT(diagonal, 0);
            EXPECT_NEAR(-by_id.value(Field::viscous_force, id, axis), diagonal, 1e-11 * diagonal) << id;
            by_id.value(Field::viscous_velocity, id, axis) = 0;
            ++camera_of;
        }
    }
    EXPECT_GT(camera_of, 10U);
}

TEST_P(ViscousSweepOf, bits_do_not_depend_on_the_arrangement) {
    const auto forces_in = [&](const Arrangement& arrangement) {
        ArrangedCrowd arranged(set, settings, arrangement);
        arranged.sweeps().viscous_forces(arranged.particles(), arranged.list(),
                                         {Field::velocity, 1, largest_term(arranged.sweeps())});
        const ById by_id(arranged.particles());
        std::vector<Vec> forces;
        for (std::size_t id = 0; id < set.size(); ++id) forces.push_back(by_id.vector(Field::viscous_force, id));
        return forces;
    };
    const auto first = forces_in({});
    for (const Arrangement& other :
         {Arrangement{.threads = 3}, Arrangement{.extra_reach = 0.05}, Arrangement{.near_only = true},
          Arrangement{.shuffled = 9}, Arrangement{.wrapped = true}})
        EXPECT_EQ(forces_in(other), first);
    for (const VectorUnit unit : available_vector_units()) EXPECT_EQ(forces_in({.vector_unit = unit}), first);
}

std::string name_of(const testing::TestParamInfo<Variant>& variant) {
    const auto& [dimension, force, walls] = variant.param;
    const std::string law = to_string(force.law) + "_" + to_string(force.mean);
    return std::to_string(dimension) + "d_" + law + (walls == WallModel::plain ? "_plain" : "_extrapolated");
}

INSTANTIATE_TEST_SUITE_P(Variants, ViscousSweepOf,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(LawWithMean{}, LawWithMean{{}, ViscosityMean::arithmetic},
                                                          LawWithMean{ViscousLaw::of<MonaghanViscosity>()},
                                                          LawWithMean{ViscousLaw::of<ClearyViscosity>()}),
                                          testing::Values(WallModel::extrapolated, WallModel::plain)),
                         name_of);

}  // namespace
}  // namespace dmp::tests::solver_viscous_sweep_tests
