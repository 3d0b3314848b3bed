// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps that run only where a scene asks for them, against plain loops over all pairs.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "arranged_crowd.hpp"
#include "base/simd/lanes.hpp"
#include "models/sph/density_diffusion.hpp"
#include "models/sph/kernels.hpp"
#include "models/sph/shifting.hpp"
#include "models/sph/walls.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_option_sweeps_tests {
namespace {

template <int N>
struct Dimension {
    static constexpr int value = N;
};

template <class Of>
class OptionSweeps : public testing::Test {
  protected:
    static constexpr int D = Of::value;
    using Matrix = Eigen::Matrix<double, D, D>;
    using V = Eigen::Matrix<double, D, 1>;

    [[nodiscard]] bool is_fluid(std::size_t id) const { return set.kind(id) == PartKind::fluid; }

    /// Each difference, to the largest that is expected.
    static void expect_near(const std::vector<Vec>& found, const std::vector<Vec>& expected, double relative) {
        double largest = 0;
        for (const Vec& value : expected) largest = std::max(largest, value.norm());
        EXPECT_GT(largest, 0);
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_LT((found[i] - expected[i]).norm(), relative * largest) << "particle " << i;
    }
    static std::vector<Vec> differences(const std::vector<Vec>& a, const std::vector<Vec>& b) {
        std::vector<Vec> all;
        for (std::size_t i = 0; i < a.size(); ++i) all.emplace_back(a[i] - b[i]);
        return all;
    }
    /// Of multiples of one quantum: exactly nothing.
    static void expect_no_force_in_all(const Sums& sums) {
        Vec total = Vec::Zero();
        for (const Vec& force : sums.force) total += force;
        EXPECT_EQ(total, Vec(Vec::Zero()));
    }

    const ParticleSet set = crowd(D, {true, false, D == 3}, 4);
    const PairSettings base = crowd_settings(set, false);
    const WendlandC2<D> kernel{base.support};
};

using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(OptionSweeps, Dimensions);

TYPED_TEST(OptionSweeps, summed_densities_are_those_of_all_pairs) {
    const ParticleSet& all = this->set;
    const std::vector<double> rest{1000, 500, 700};  // the solids' are nobody's business
    PairSettings settings = this->base;
    settings.density.by_summation = true;
    for (const VectorUnit unit : available_vector_units()) {
        ArrangedCrowd arranged(all, settings, {.vector_unit = unit});
        EXPECT_FALSE(arranged.particles().fluid().has(Field::density_rate));
        const std::vector<double> found = arranged.densities(rest);
        std::vector<double> expected(all.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            if (this->is_fluid(i)) expected[i] = 1000 * all.volume[i] * this->kernel.value(0.0);
        for_all_pairs(arranged.particles(), settings.support, [&](const Meeting& m) {
            if (this->is_fluid(m.i)) expected[m.i] += 1000 * all.volume[m.j] * this->kernel.value(m.separation.norm());
        });
        for (std::size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << "particle " << i;
    }
}

TYPED_TEST(OptionSweeps, transport_velocity_adds_a_stress_and_spreads) {
    const ParticleSet& all = this->set;
    PairSettings settings = this->base;
    for (const VectorUnit unit : available_vector_units()) {
        settings.transport_velocity = false;
        const Sums without = ArrangedCrowd(all, settings, {.vector_unit = unit}).sweep();
        settings.transport_velocity = true;
        ArrangedCrowd arranged(all, settings, {.vector_unit = unit});
        const Sums with = arranged.sweep();
        const ById by_id(arranged.particles());
        std::vector<Vec> stress(all.size(), Vec::Zero()), spreading = stress;
        for_all_pairs(arranged.particles(), settings.support, [&](const Meeting& m) {
            if (!this->is_fluid(m.i)) return;
            const double vi = by_id.value(Field::volume, m.i), vj = by_id.value(Field::volume, m.j);
            const Vec gradient = this->kernel.slope(m.separation.norm()) * m.separation;
            spreading[m.i] += (vi * vi + vj * vj) / vi * gradient;
            if (!this->is_fluid(m.j)) return;
            for (const std::size_t k : {m.i, m.j})
                stress[m.i] += vi * vj * by_id.value(Field::density, k) *
                               by_id.vector(Field::transport_velocity, k).dot(gradient) *
                               by_id.vector(Field::velocity, k);
        });
        this->expect_near(with.shift, spreading, 1e-11);
        this->expect_near(this->differences(with.force, without.force), stress, 1e-9);
        this->expect_no_force_in_all(with);
        for (const ParticleGroup& group : arranged.particles().groups())
            EXPECT_EQ(group.has(Field::transport_velocity), group.kind() == PartKind::fluid);
    }
}

TYPED_TEST(OptionSweeps, corrected_gradients_are_those_of_all_pairs) {
    using M = typename TestFixture::Matrix;
    constexpr int dimension = TestFixture::D;
    const ParticleSet& all = this->set;
    PairSettings settings = this->base;
    for (const VectorUnit unit : available_vector_units()) {
        settings.gradient_correction = false;
        const Sums without = ArrangedCrowd(all, settings, {.vector_unit = unit}).sweep();
        settings.gradient_correction = true;
        ArrangedCrowd arranged(all, settings, {.vector_unit = unit});
        const Sums with = arranged.sweep();
        const ById by_id(arranged.particles());
        const auto narrow = [](const Vec& v) { return typename TestFixture::V(v.template head<dimension>()); };

        std::vector<M> excess(all.size(), M::Zero());
        for_all_pairs(arranged.particles(), settings.support, [&](const Meeting& m) {
            const auto x = narrow(m.separation);
            if (this->is_fluid(m.i))
                excess[m.i] -= by_id.value(Field::volume, m.j) * this->kernel.slope(x.norm()) * x * x.transpose();
        });
        int corrected = 0, left = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!this->is_fluid(i)) continue;
            const bool few = excess[i].determinant() < 0.3;
            (few ? left : corrected) += 1;
            excess[i] = few ? M(M::Zero()) : M(excess[i].inverse() - M::Identity());
        }
        EXPECT_GT(corrected, 50);
        EXPECT_GT(left, 0) << "of those at the edge";

        std::vector<Vec> force(all.size(), Vec::Zero());
        std::vector<double> rate(all.size());
        for_all_pairs(arranged.particles(), settings.support, [&](const Meeting& m) {
            if (!this->is_fluid(m.i)) return;
            const auto gradient = narrow(this->kernel.slope(m.separation.norm()) * m.separation);
            const double vi = by_id.value(Field::volume, m.i), vj = by_id.value(Field::volume, m.j);
            const double pi = by_id.value(Field::pressure, m.i);
            typename TestFixture::V sum = pi * excess[m.i] * gradient;
            double weight = 1;
            if (this->is_fluid(m.j)) {
                sum += by_id.value(Field::pressure, m.j) * excess[m.j] * gradient;
            } else {  // sees its own state there; in a wall with the hydrostatic difference
                const bool is_wall = all.kind(m.j) == PartKind::rigid;
                const Vec g(ArrangedCrowd::body_acceleration[0], ArrangedCrowd::body_acceleration[1],
                            dimension == 3 ? ArrangedCrowd::body_acceleration[2] : 0);
                const double beyond = is_wall ? by_id.value(Field::density, m.i) * g.dot(m.separation) : 0;
                sum += (pi - beyond) * excess[m.i] * gradient;
                weight = 2;
            }
            force[m.i].template head<dimension>() -= vi * vj * sum;
            if (!this->is_fluid(m.j)) force[m.j].template head<dimension>() += vi * vj * sum;
            const auto apart = narrow(by_id.vector(Field::velocity, m.i) - by_id.vector(Field::velocity, m.j));
            rate[m.i] += weight * by_id.value(Field::density, m.i) * vj * apart.dot(excess[m.i] * gradient);
        });
        this->expect_near(this->differences(with.force, without.force), force, 1e-9);
        this->expect_no_force_in_all(with);
        const double fastest = *std::max_element(rate.begin(), rate.end());
        for (std::size_t i = 0; i < all.size(); ++i)
            EXPECT_NEAR(with.density_rate[i] - without.density_rate[i], rate[i], 1e-9 * fastest) << "particle " << i;
    }
}

TYPED_TEST(OptionSweeps, stratified_fluid_is_shifted_and_diffused_less) {
    constexpr int dimension = TestFixture::D;
    const ParticleSet& all = this->set;
    PairSettings settings = this->base;
    settings.shifting = 4;
    const double delta = 0.1;
    for (const VectorUnit unit : available_vector_units()) {
        settings.hydrostatic = false;
        settings.density.diffusion = 0;
        const Sums plain = ArrangedCrowd(all, settings, {.vector_unit = unit}).sweep();
        settings.hydrostatic = true;
        settings.density.diffusion = delta;
        ArrangedCrowd arranged(all, settings, {.vector_unit = unit});
        const Sums found = arranged.sweep();
        const ById by_id(arranged.particles());
        const auto& a = ArrangedCrowd::body_acceleration;
        const Vec g(a[0], a[1], dimension == 3 ? a[2] : 0);
        std::vector<double> divergence(all.size()), diffusion(all.size());
        for_all_pairs(arranged.particles(), settings.support, [&](const Meeting& m) {
            if (!this->is_fluid(m.i)) return;
            const double slope = this->kernel.slope(m.separation.norm()), vj = by_id.value(Field::volume, m.j);
            divergence[m.i] -= vj * slope * m.separation.squaredNorm();
            if (!this->is_fluid(m.j)) return;
            const double pressures = by_id.value(Field::pressure, m.i) - by_id.value(Field::pressure, m.j);
            const double density = 0.5 * (by_id.value(Field::density, m.i) + by_id.value(Field::density, m.j));
            diffusion[m.i] += delta * settings.support / settings.sound_speed * vj * slope *
                              (pressures - density * g.dot(m.separation));
        });
        int at_surface = 0, inside = 0, between = 0;
        const double most = *std::max_element(diffusion.begin(), diffusion.end());
        EXPECT_GT(most, 0);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!this->is_fluid(i)) continue;
            const double kept = std::clamp((divergence[i] - 0.75 * dimension) / (0.25 * dimension), 0.0, 1.0);
            ++(kept == 0 ? at_surface : kept == 1 ? inside : between);
            EXPECT_LT((found.shift[i] - kept * plain.shift[i]).norm(), 1e-12 * (1 + plain.shift[i].norm()));
            EXPECT_NEAR(found.density_rate[i] - plain.density_rate[i], diffusion[i], 1e-9 * most);
        }
        EXPECT_GT(at_surface, 0);
        EXPECT_GT(inside, 0);
        EXPECT_GT(between, 0);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_option_sweeps_tests
