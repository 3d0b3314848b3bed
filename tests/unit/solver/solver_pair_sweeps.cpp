// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "all_pairs.hpp"
#include "particles/kernels.hpp"
#include "solver/models/contact/repulsion.hpp"
#include "solver/models/sph/continuity.hpp"
#include "solver/models/sph/density_diffusion.hpp"
#include "solver/models/sph/morris_viscosity.hpp"
#include "solver/models/sph/pressure_force.hpp"
#include "solver/models/sph/shifting.hpp"
#include "solver/models/sph/walls.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/sweeps/point_reader.hpp"

namespace dmp {
namespace {

using testing_solver::crowd;
using testing_solver::for_all_pairs;
using testing_solver::never_meet;
using V2 = Vector<double, 2>;

const std::array<double, 3> body_acceleration{0.7, -2.5, 0};

/// What the sweeps should leave in the store, by particle.
struct Sums {
    std::vector<V2> force, shift;
    std::vector<double> density_rate;
};

/// The laws on pairs of plain numbers, one pair after another.
template <class Kernel, class Solid>
class AllPairs {
  public:
    AllPairs(const ParticleStore& particles, const ParticleSet& set, const PairSettings& settings, const Solid& solid)
        : particles_(particles),
          set_(set),
          settings_(settings),
          kernel_(settings.support),
          solid_(solid),
          diffusion_(settings.density_diffusion, settings.support, settings.sound_speed),
          shifting_(settings.shifting, settings.support, settings.spacing, kernel_),
          read_(particles) {}

    Sums sums() {
        sums_ = {std::vector<V2>(set_.size(), V2::zero()), std::vector<V2>(set_.size(), V2::zero()),
                 std::vector<double>(set_.size(), 0.0)};
        for_all_pairs(particles_, set_, settings_.support, [this](int i, int j, const V2& separation) {
            if (never_meet(set_, i, j)) return;
            if (set_.kind(i) == ParticleKind::fluid) {
                if (set_.kind(j) == ParticleKind::fluid) {
                    two_fluids(i, j, separation);
                } else {
                    fluid_and_solid(i, j, separation);
                }
            } else if (set_.kind(j) != ParticleKind::fluid) {
                two_solids(i, j, separation);
            }
        });
        return sums_;
    }

  private:
    template <class I, class J>
    [[nodiscard]] auto pair(const I& i, const J& j, const V2& separation) const {
        const double r = std::sqrt(dot(separation, separation));
        return Pair<I, J, V2, double>{i, j, separation, r, kernel_.slope(r)};
    }

    void two_fluids(int i, int j, const V2& separation) {
        const auto a = read_.fluid(i), b = read_.fluid(j);
        const auto p = pair(a, b, separation);
        sums_.force[i] += PressureForce::law(p) + MorrisViscosity::law(p);
        sums_.density_rate[i] += ContinuityRate::law(p);
        if (settings_.density_diffusion > 0) sums_.density_rate[i] += diffusion_.law(p);
        sums_.shift[i] += shifting_.law(p, kernel_);
    }

    void fluid_and_solid(int i, int j, const V2& separation) {
        const auto fluid = read_.fluid(i);
        const bool wall = set_.kind(j) == ParticleKind::rigid;
        const auto solid = [&] {
            if constexpr (Solid::needs_surface)
                if (wall) return read_.template solid<true>(j);
            return read_.template solid<false>(j);
        }();
        const auto ghost = wall ? solid_.rigid(fluid, solid, separation) : solid_.springs(fluid, solid, separation);
        const auto seen = pair(fluid, ghost, separation);
        const V2 force =
            PressureForce::law(seen) + MorrisViscosity::law(seen) + contact(Field::contact_range, i, j, separation);
        sums_.force[i] += force;
        sums_.force[j] -= force;

        const auto itself = pair(fluid, solid, separation);
        sums_.density_rate[i] += Solid::approach_weight * ContinuityRate::law(itself);
        sums_.shift[i] += shifting_.law(itself, kernel_);
        if (settings_.walls == WallModel::plain)
            sums_.density_rate[j] += ContinuityRate::law(pair(solid, fluid, -1.0 * separation));
    }

    void two_solids(int i, int j, const V2& separation) {
        const bool with_wall = set_.kind(i) == ParticleKind::rigid || set_.kind(j) == ParticleKind::rigid;
        sums_.force[i] += contact(with_wall ? Field::wall_contact_range : Field::contact_range, i, j, separation);
    }

    [[nodiscard]] V2 contact(Field range, int i, int j, const V2& separation) const {
        if (settings_.repulsion_strength == 0) return V2::zero();
        const double* ranges = particles_.data(range);
        return Repulsion{settings_.repulsion_strength}.law(separation, std::min(ranges[i], ranges[j]));
    }

    const ParticleStore& particles_;
    const ParticleSet& set_;
    PairSettings settings_;
    Kernel kernel_;
    Solid solid_;
    DensityDiffusion diffusion_;
    Shifting<Kernel> shifting_;
    PointReader<2> read_;
    Sums sums_;
};

using Variant = std::tuple<KernelKind, WallModel, bool>;  ///< the last: with diffusion, shifting and contact

class PairSweepsOf : public testing::TestWithParam<Variant> {
  protected:
    PairSweepsOf() : set(crowd({true, false, false}, 3)), particles(set) {
        settings.kernel = std::get<KernelKind>(GetParam());
        settings.walls = std::get<WallModel>(GetParam());
        settings.spacing = set.spacing;
        settings.support = 3 * set.spacing;
        settings.sound_speed = 20;
        if (std::get<bool>(GetParam())) {
            settings.density_diffusion = 0.1;
            settings.shifting = 4;
            settings.repulsion_strength = 1e-3;
        }
        sweeps = make_pair_sweeps(settings, particles);
        fill();
        const double reach = 1.13 * settings.support;
        particles.renew_images(set.box, set.periodic, reach);
        list.build(particles, set, reach, 1);
    }

    void fill() {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (std::size_t i = 0; i < set.size(); ++i) {
            for (int axis = 0; axis < 2; ++axis) particles.data(Field::velocity, axis)[i] = unit(random);
            particles.data(Field::density)[i] = 1000 + 10 * unit(random);
            particles.data(Field::pressure)[i] = 3000 * (unit(random) + 0.5);
            particles.data(Field::viscosity)[i] = set.kind(i) == ParticleKind::fluid ? 0.5 + 0.2 * unit(random) : 0;
            particles.data(Field::contact_range)[i] = set.spacing;
            particles.data(Field::wall_contact_range)[i] = i % 3 == 0 ? 0 : set.spacing;
            if (!particles.has(Field::wall_normal)) continue;
            particles.data(Field::wall_distance)[i] = set.wall_distance[i];
            for (int axis = 0; axis < 2; ++axis) particles.data(Field::wall_normal, axis)[i] = set.wall_normal[i][axis];
        }
    }

    void sweep() {
        sweeps->forces(particles, list, body_acceleration);
        sweeps->density_rates(particles, list);
    }

    template <class Kernel>
    [[nodiscard]] Sums sums_with() const {
        if (settings.walls == WallModel::plain)
            return AllPairs<Kernel, PlainSolid<2>>(particles, set, settings, {}).sums();
        const ExtrapolatedSolid<2> solid{{{body_acceleration[0], body_acceleration[1]}}, 0.5 * settings.spacing};
        return AllPairs<Kernel, ExtrapolatedSolid<2>>(particles, set, settings, solid).sums();
    }
    [[nodiscard]] Sums all_pairs() const {
        return settings.kernel == KernelKind::lucy ? sums_with<Lucy<2>>() : sums_with<WendlandC2<2>>();
    }

    [[nodiscard]] std::vector<V2> vectors(Field field) const {
        std::vector<V2> values;
        for (std::size_t i = 0; i < set.size(); ++i)
            values.push_back({{particles.data(field, 0)[i], particles.data(field, 1)[i]}});
        return values;
    }

    ParticleSet set;
    ParticleStore particles;
    PairSettings settings;
    std::unique_ptr<PairSweeps> sweeps;
    ClusterList list;
};

double largest(const std::vector<V2>& vectors) {
    double size = 0;
    for (const V2& v : vectors) size = std::max(size, std::sqrt(dot(v, v)));
    return size;
}

void expect_equal(const std::vector<V2>& found, const std::vector<V2>& expected) {
    const double tolerance = 1e-12 * largest(expected);
    ASSERT_GT(tolerance, 0);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_NEAR(found[i][axis], expected[i][axis], tolerance) << "particle " << i << ", axis " << axis;
}

TEST_P(PairSweepsOf, forces_are_those_of_all_pairs) {
    sweep();
    expect_equal(vectors(Field::force), all_pairs().force);
}

TEST_P(PairSweepsOf, forces_add_up_to_nothing) {
    sweep();
    const auto force = vectors(Field::force);
    V2 sum = V2::zero();
    for (const V2& f : force) sum += f;
    EXPECT_LT(std::sqrt(dot(sum, sum)), 1e-12 * largest(force) * std::sqrt(static_cast<double>(set.size())));
}

TEST_P(PairSweepsOf, density_rates_are_those_of_all_pairs) {
    sweep();
    const auto expected = all_pairs().density_rate;
    const double* found = particles.data(Field::density_rate);
    const double tolerance = 1e-12 * *std::max_element(expected.begin(), expected.end());
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (settings.walls == WallModel::extrapolated && set.kind(i) != ParticleKind::fluid) continue;
        EXPECT_NEAR(found[i], expected[i], tolerance) << "particle " << i;
    }
}

TEST_P(PairSweepsOf, shifts_are_those_of_all_pairs) {
    sweep();
    if (settings.shifting == 0) {
        EXPECT_FALSE(particles.has(Field::shift));
        return;
    }
    auto expected = all_pairs().shift;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) != ParticleKind::fluid) expected[i] = V2::zero();
    expect_equal(vectors(Field::shift), expected);
}

TEST_P(PairSweepsOf, results_are_the_same_bits_on_any_number_of_threads) {
    sweep();
    const auto force = vectors(Field::force);
    const std::vector<double> rate(particles.data(Field::density_rate),
                                   particles.data(Field::density_rate) + set.size());
    for (const int threads : {2, 3}) {
        settings.threads = threads;
        sweeps = make_pair_sweeps(settings, particles);
        list.build(particles, set, 1.13 * settings.support, threads);
        sweep();
        const auto again = vectors(Field::force);
        for (std::size_t i = 0; i < set.size(); ++i) {
            EXPECT_EQ(again[i][0], force[i][0]);
            EXPECT_EQ(again[i][1], force[i][1]);
            EXPECT_EQ(particles.data(Field::density_rate)[i], rate[i]);
        }
    }
}

TEST_P(PairSweepsOf, kernels_are_those_asked_for) {
    const double r = 0.4 * settings.support;
    if (settings.kernel == KernelKind::lucy) {
        EXPECT_EQ(sweeps->kernel_value(r), Lucy<2>(settings.support).value(r));
        EXPECT_EQ(sweeps->kernel_slope(r), Lucy<2>(settings.support).slope(r));
        EXPECT_EQ(sweeps->viscous_limit(), Lucy<2>::viscous_limit);
        EXPECT_EQ(sweeps->sound_limit(), Lucy<2>::sound_limit);
    } else {
        EXPECT_EQ(sweeps->kernel_value(r), WendlandC2<2>(settings.support).value(r));
        EXPECT_EQ(sweeps->kernel_slope(r), WendlandC2<2>(settings.support).slope(r));
        EXPECT_EQ(sweeps->viscous_limit(), WendlandC2<2>::viscous_limit);
        EXPECT_EQ(sweeps->sound_limit(), WendlandC2<2>::sound_limit);
    }
}

std::string name_of(const testing::TestParamInfo<Variant>& variant) {
    const auto& [kernel, walls, extras] = variant.param;
    return word(kernel) + "_" + word(walls) + (extras ? "_with_extras" : "");
}

INSTANTIATE_TEST_SUITE_P(Variants, PairSweepsOf,
                         testing::Combine(testing::Values(KernelKind::wendland_c2, KernelKind::lucy),
                                          testing::Values(WallModel::extrapolated, WallModel::plain), testing::Bool()),
                         name_of);

TEST(PairSweeps, declare_only_the_fields_they_need) {
    const ParticleSet set = crowd({false, false, false});
    PairSettings settings{.spacing = 0.1, .support = 0.3, .sound_speed = 20};
    ParticleStore bare(set);
    settings.walls = WallModel::plain;
    make_pair_sweeps(settings, bare);
    EXPECT_FALSE(bare.has(Field::wall_normal));
    EXPECT_FALSE(bare.has(Field::wall_distance));
    EXPECT_FALSE(bare.has(Field::shift));
    EXPECT_TRUE(bare.has(Field::density_rate));
}

}  // namespace
}  // namespace dmp
