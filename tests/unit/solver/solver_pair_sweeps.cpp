// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "arranged_crowd.hpp"
#include "base/errors.hpp"
#include "base/simd/lanes.hpp"
#include "models/contact/repulsion.hpp"
#include "models/sph/continuity.hpp"
#include "models/sph/density_diffusion.hpp"
#include "models/sph/kernels.hpp"
#include "models/sph/pressure_force.hpp"
#include "models/sph/shifting.hpp"
#include "models/sph/viscous_laws.hpp"
#include "models/sph/walls.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_pair_sweeps_tests {
namespace {

template <int D>
Vector<double, D> narrowed(const Vec& v) {
    Vector<double, D> narrow;
    for (int axis = 0; axis < D; ++axis) narrow[axis] = v[axis];
    return narrow;
}

/// The laws on pairs of plain numbers, one pair after another.
template <int D, class Kernel, class Solid>
class AllPairs {
  public:
    AllPairs(ParticleStore& particles, const ParticleSet& set, const PairSettings& settings, const Solid& solid)
        : particles_(particles),
          set_(set),
          settings_(settings),
          kernel_(settings.support),
          solid_(solid),
          diffusion_(settings.density.diffusion, settings.support, settings.sound_speed),
          shifting_(settings.shifting, settings.support, settings.spacing, kernel_),
          by_id_(particles) {}

    Sums sums() {
        for_all_pairs(particles_, settings_.support, [this](const Meeting& m) {
            const bool i_is_fluid = set_.kind(m.i) == PartKind::fluid;
            const bool j_is_fluid = set_.kind(m.j) == PartKind::fluid;
            const V separation = narrowed<D>(m.separation);
            if (never_meet(set_, m.i, m.j)) return;
            if (i_is_fluid && j_is_fluid) two_fluids(m.i, m.j, separation);
            if (i_is_fluid && !j_is_fluid) fluid_and_solid(m.i, m.j, separation);
            if (!i_is_fluid && !j_is_fluid) two_solids(m.i, m.j, separation);
        });
        return sums_;
    }

  private:
    using V = Vector<double, D>;

    template <class I, class J>
    [[nodiscard]] auto pair(const I& i, const J& j, const V& separation) const {
        const double r = std::sqrt(dot(separation, separation));
        return Pair<I, J, V, double, double>{i, j, separation, r, kernel_.slope(r)};
    }
    [[nodiscard]] auto fluid(std::size_t id) const {
        if (settings_.corrected) return FluidReader<Lanes, D, true>(by_id_.group(id))(by_id_.index(id));
        return FluidReader<Lanes, D>(by_id_.group(id))(by_id_.index(id));
    }
    template <bool IsWall>
    [[nodiscard]] auto solid(std::size_t id) const {
        return SolidReader < Lanes, D, Solid::needs_state,
               IsWall && Solid::needs_surface > (by_id_.group(id))(by_id_.index(id));
    }
    static void add(const V& term, Vec& sum) {
        for (int axis = 0; axis < D; ++axis) sum[axis] += term[axis];
    }

    void two_fluids(std::size_t i, std::size_t j, const V& separation) {
        const auto a = fluid(i), b = fluid(j);
        const auto p = pair(a, b, separation);
        add(PressureForce::law(p) + viscous(p), sums_.force[i]);
        sums_.density_rate[i] += ContinuityRate::law(p);
        if (settings_.density.diffusion > 0) sums_.density_rate[i] += diffusion_.law(p);
        if (settings_.shifting > 0) add(shifting_.law(p, kernel_), sums_.shift[i]);
    }

    void fluid_and_solid(std::size_t i, std::size_t j, const V& separation) {
        const auto a = fluid(i);
        const bool is_wall = set_.kind(j) == PartKind::rigid;
        const auto b = is_wall ? solid<true>(j) : solid<false>(j);
        const auto ghost = is_wall ? solid_.rigid(a, b, separation) : solid_.springs(a, b, separation);
        const auto seen = pair(a, ghost, separation);
        const V force = PressureForce::law(seen) + viscous(seen) + contact(Field::contact_range, i, j, separation);
        add(force, sums_.force[i]);
        add(-1.0 * force, sums_.force[j]);

        const auto itself = pair(a, b, separation);
        sums_.density_rate[i] += Solid::approach_weight * ContinuityRate::law(itself);
        if (settings_.shifting > 0) add(shifting_.law(itself, kernel_), sums_.shift[i]);
        if (Solid::needs_state) sums_.density_rate[j] += ContinuityRate::law(pair(b, a, -1.0 * separation));
    }

    void two_solids(std::size_t i, std::size_t j, const V& separation) {
        const bool with_wall = set_.kind(i) == PartKind::rigid || set_.kind(j) == PartKind::rigid;
        add(contact(with_wall ? Field::wall_contact_range : Field::contact_range, i, j, separation), sums_.force[i]);
    }

    template <class P>
    [[nodiscard]] V viscous(const P& p) const {
        if (settings_.viscosity.implicit) return V::zero();
        const ViscousScales scales =
            viscous_scales(D, settings_.spacing, settings_.support, [this](double r) { return kernel_.slope(r); });
        const bool arithmetic = settings_.viscosity.mean == ViscosityMean::arithmetic ||
                                (settings_.viscosity.law.is<MorrisViscosity>() && !settings_.viscosity.unlike);
        return AnyViscousTerm(settings_.viscosity.law, scales, arithmetic).law(p);
    }

    [[nodiscard]] V contact(Field range, std::size_t i, std::size_t j, const V& separation) const {
        if (settings_.repulsion_strength == 0) return V::zero();
        return Repulsion{settings_.repulsion_strength}.law(separation,
                                                           std::min(by_id_.value(range, i), by_id_.value(range, j)));
    }

    ParticleStore& particles_;
    const ParticleSet& set_;
    PairSettings settings_;
    Kernel kernel_;
    Solid solid_;
    DensityDiffusion diffusion_;
    Shifting<Kernel> shifting_;
    ById by_id_;
    Sums sums_{set_.size()};
};

template <int D, class Kernel>
Sums sums_of_all_pairs(ParticleStore& particles, const ParticleSet& set, const PairSettings& settings) {
    if (settings.walls.model == WallModel::plain)
        return AllPairs<D, Kernel, PlainSolid<D>>(particles, set, settings, {}).sums();
    const auto& g = ArrangedCrowd::body_acceleration;
    const ExtrapolatedSolid<D> solid{narrowed<D>(Vec(g[0], g[1], g[2])), 0.5 * settings.spacing};
    return AllPairs<D, Kernel, ExtrapolatedSolid<D>>(particles, set, settings, solid).sums();
}

/// Calls then(kernel) with the kernel of the settings.
template <int D, class Then>
auto with_kernel(const PairSettings& settings, const Then& then) {
    switch (settings.kernel) {
        case KernelKind::wendland_c4:
            return then(WendlandC4<D>(settings.support));
        case KernelKind::lucy:
            return then(Lucy<D>(settings.support));
        case KernelKind::cubic_spline:
            return then(CubicSpline<D>(settings.support));
        case KernelKind::quintic_spline:
            return then(QuinticSpline<D>(settings.support));
        default:
            return then(WendlandC2<D>(settings.support));
    }
}

template <int D>
Sums sums_in_space_of(ParticleStore& particles, const ParticleSet& set, const PairSettings& settings) {
    return with_kernel<D>(settings, [&](const auto& kernel) {
        return sums_of_all_pairs<D, std::decay_t<decltype(kernel)>>(particles, set, settings);
    });
}

Sums sums_of_all_pairs(ParticleStore& particles, const ParticleSet& set, const PairSettings& settings) {
    return set.dimension == 3 ? sums_in_space_of<3>(particles, set, settings)
                              : sums_in_space_of<2>(particles, set, settings);
}

/// How far sums may be from those of the oracle: each of their terms, fewer than 256, is rounded to 2^-46 of the
/// largest that is expected (sweeps/reproducible_sum.hpp), that is by half of that at most. The laws' own rounding is
/// less.
struct Tolerance {
    double force, density_rate, shift;

    Tolerance(const PairSweeps& sweeps, const PairSettings& settings, int dimension) {
        double steepest = 0;
        for (double r = 0; r < settings.support; r += 0.01 * settings.support)
            steepest = std::max(steepest, -sweeps.kernel_slope(r) * r);
        const double volume = std::pow(settings.spacing, dimension), c0 = settings.sound_speed;
        const double terms = std::ldexp(128, -46);
        force = terms * 0.2 * settings.density.largest * c0 * c0 * volume * volume * steepest;
        density_rate = terms * settings.density.largest * c0 * volume * steepest;
        shift = terms * 1.2 * volume * steepest;
    }
};

void expect_near(const std::vector<Vec>& found, const std::vector<Vec>& expected, double tolerance) {
    double largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(found[i][axis], expected[i][axis], tolerance) << "particle " << i << ", axis " << axis;
        largest = std::max(largest, expected[i].norm());
    }
    EXPECT_GT(largest, 1e9 * tolerance);
}

using Variant = std::tuple<int, KernelKind, WallModel, bool>;  ///< the last: with diffusion, shifting and contact

class PairSweepsOf : public testing::TestWithParam<Variant> {
  protected:
    PairSweepsOf()
        : set(crowd(std::get<int>(GetParam()), {true, false, std::get<int>(GetParam()) == 3}, 3)),
          settings(crowd_settings(set, std::get<bool>(GetParam()), std::get<WallModel>(GetParam()))) {
        settings.kernel = std::get<KernelKind>(GetParam());
    }

    ParticleSet set;
    PairSettings settings;
};

TEST_P(PairSweepsOf, sums_are_those_of_all_pairs) {
    for (const VectorUnit unit : available_vector_units()) {
        SCOPED_TRACE(to_string(unit));
        ArrangedCrowd arranged(set, settings, {.vector_unit = unit});
        const Sums found = arranged.sweep(), expected = sums_of_all_pairs(arranged.particles(), set, settings);
        const Tolerance tolerance(arranged.sweeps(), settings, set.dimension);
        expect_near(found.force, expected.force, tolerance.force);
        for (std::size_t i = 0; i < set.size(); ++i)
            EXPECT_NEAR(found.density_rate[i], expected.density_rate[i], tolerance.density_rate) << "particle " << i;
        if (settings.shifting > 0) expect_near(found.shift, expected.shift, tolerance.shift);
        for (const ParticleGroup& group : arranged.particles().groups())
            EXPECT_EQ(group.has(Field::shift), settings.shifting > 0 && group.kind() == PartKind::fluid);
    }
}

TEST_P(PairSweepsOf, forces_add_up_to_nothing_at_all) {
    for (const VectorUnit unit : available_vector_units()) {
        ArrangedCrowd arranged(set, settings, {.vector_unit = unit});
        const Sums found = arranged.sweep();
        for (int axis = 0; axis < set.dimension; ++axis) {
            double sum = 0, largest = 0;  // of multiples of one quantum: exact
            for (const Vec& force : found.force) {
                sum += force[axis];
                largest = std::max(largest, std::abs(force[axis]));
            }
            EXPECT_EQ(sum, 0) << to_string(unit) << ", axis " << axis;
            EXPECT_GT(largest, 0);
        }
    }
}

TEST_P(PairSweepsOf, kernels_are_those_asked_for) {
    const ArrangedCrowd arranged(set, settings, {});
    const PairSweeps& sweeps = arranged.sweeps();
    const double r = 0.4 * settings.support;
    const auto expect_kernel = [&](const auto& kernel) {
        EXPECT_DOUBLE_EQ(sweeps.kernel_value(r), kernel.value(r));
        EXPECT_DOUBLE_EQ(sweeps.kernel_slope(r), kernel.slope(r));
        EXPECT_EQ(sweeps.viscous_limit(), kernel.viscous_limit);
        EXPECT_EQ(sweeps.sound_limit(), kernel.sound_limit);
    };
    set.dimension == 3 ? with_kernel<3>(settings, expect_kernel) : with_kernel<2>(settings, expect_kernel);
}

std::string name_of(const testing::TestParamInfo<Variant>& variant) {
    const auto& [dimension, kernel, walls, extras] = variant.param;
    return std::to_string(dimension) + "d_" + to_string(kernel) + "_" + to_string(walls) +
           (extras ? "_with_extras" : "");
}

INSTANTIATE_TEST_SUITE_P(Variants, PairSweepsOf,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(KernelKind::wendland_c2, KernelKind::wendland_c4,
                                                          KernelKind::lucy, KernelKind::cubic_spline,
                                                          KernelKind::quintic_spline),
                                          testing::Values(WallModel::extrapolated, WallModel::plain), testing::Bool()),
                         name_of);

/// Viscous laws other than the usual one, with walls of either kind.
class ViscousSweeps : public testing::TestWithParam<std::tuple<int, WallModel>> {};

TEST_P(ViscousSweeps, are_those_of_all_pairs_and_leave_no_force_in_all) {
    const int dimension = std::get<0>(GetParam());
    const WallModel walls = std::get<1>(GetParam());
    const ParticleSet set = crowd(dimension, {true, false, dimension == 3}, 5);
    PairSettings settings = crowd_settings(set, true, walls);
    std::vector<std::vector<Vec>> seen;
    settings.viscosity.unlike = true;
    const auto expect_oracle = [&](ViscousLaw law, ViscosityMean mean) {
        settings.viscosity.law = law;
        settings.viscosity.mean = mean;
        settings.corrected = law.is<NewtonianViscosity>() && walls == WallModel::extrapolated;
        if (law.is<NewtonianViscosity>() && !settings.corrected) return;  // refused with plain walls
        std::vector<Vec> first;
        for (const VectorUnit unit : available_vector_units()) {
            ArrangedCrowd arranged(set, settings, {.vector_unit = unit, .threads = 2});
            const Sums found = arranged.sweep();
            const Tolerance tolerance(arranged.sweeps(), settings, dimension);
            expect_near(found.force, sums_of_all_pairs(arranged.particles(), set, settings).force, tolerance.force);
            for (int axis = 0; axis < dimension; ++axis) {
                double sum = 0;  // of multiples of one quantum: exact
                for (const Vec& force : found.force) sum += force[axis];
                EXPECT_EQ(sum, 0);
            }
            if (first.empty()) first = found.force;
            EXPECT_EQ(found.force, first) << "not the same bits for " << to_string(unit);
        }
        for (const auto& other : seen) EXPECT_NE(first, other) << "two laws are one";
        seen.push_back(first);
    };
    for (std::size_t number = 0; number < ViscousLaws::size; ++number)
        for (const ViscosityMean mean : {ViscosityMean::harmonic, ViscosityMean::arithmetic})
            expect_oracle(ViscousLaw(number), mean);
    settings.viscosity.implicit = true;  // forces without viscosity
    expect_oracle({}, ViscosityMean::harmonic);
}

INSTANTIATE_TEST_SUITE_P(Variants, ViscousSweeps,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(WallModel::extrapolated, WallModel::plain)),
                         [](const auto& variant) {
                             return std::to_string(std::get<int>(variant.param)) + "d_" +
                                    to_string(std::get<WallModel>(variant.param));
                         });

TEST(PairSweeps, declare_only_the_fields_they_need) {
    const ParticleSet set = crowd(2, {false, false, false});
    const auto declared = [&](WallModel walls, bool extras) {
        ParticleStore particles(set, {1000, 1000, 1000});
        make_pair_sweeps(crowd_settings(set, extras, walls), particles);
        return particles;
    };
    const ParticleStore bare = declared(WallModel::extrapolated, false), plain = declared(WallModel::plain, false);
    const ParticleStore full = declared(WallModel::extrapolated, true);
    for (const PartKind kind : all_kinds) {
        const bool is_fluid = kind == PartKind::fluid, is_wall = kind == PartKind::rigid;
        EXPECT_EQ(bare.of(kind).has(Field::density_rate), is_fluid);
        EXPECT_TRUE(plain.of(kind).has(Field::density_rate));
        EXPECT_EQ(bare.of(kind).has(Field::viscosity), is_fluid);
        EXPECT_EQ(bare.of(kind).has(Field::wall_normal), !is_fluid);
        EXPECT_EQ(bare.of(kind).has(Field::wall_distance), !is_fluid);
        EXPECT_EQ(bare.of(kind).has(Field::opposite_distance), !is_fluid && !is_wall);
        EXPECT_FALSE(bare.of(kind).has(Field::shift));
        EXPECT_EQ(full.of(kind).has(Field::shift), is_fluid);
        EXPECT_FALSE(bare.of(kind).has(Field::contact_range));
        EXPECT_TRUE(full.of(kind).has(Field::contact_range));
        EXPECT_EQ(full.of(kind).has(Field::wall_contact_range), !is_fluid);
    }
}

TEST(PairSweeps, unit_that_is_no_unit_of_this_processor_is_an_error) {
    const ParticleSet set = crowd(2, {false, false, false});
    ParticleStore particles(set, {1000, 1000, 1000});
    PairSettings settings = crowd_settings(set, false);
    settings.vector_unit =
        available_vector_units().front() == VectorUnit::generic ? VectorUnit::avx2 : VectorUnit::generic;
    EXPECT_THROW(make_pair_sweeps(settings, particles), ResourceError);
}

}  // namespace
}  // namespace dmp::tests::solver_pair_sweeps_tests
