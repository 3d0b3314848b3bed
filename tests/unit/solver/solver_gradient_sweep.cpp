// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The density sweep of the corrected scheme, against sums over all pairs and against what it must be exact for.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "arranged_crowd.hpp"
#include "models/sph/kernels.hpp"
#include "models/sph/shifting.hpp"
#include "models/sph/velocity_gradient.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_gradient_sweep_tests {
namespace {

using Matrix = Eigen::Matrix3d;

PairSettings corrected_settings(const ParticleSet& set, bool several) {
    PairSettings settings = crowd_settings(set, true);
    settings.corrected = true;
    settings.several_fluids = several;
    return settings;
}

/// The velocity gradient of the step before, as the sums below find it.
double gradient_before(std::size_t id, int k) { return 0.3 * k - 0.2 * static_cast<double>(id % 7); }

/// What the sweep leaves of a fluid particle.
struct Found {
    Matrix velocity_gradient = Matrix::Zero();
    Vec density_gradient = Vec::Zero(), shift = Vec::Zero(), off_walls = Vec::Zero();
    double rate = 0, correction = 0;
};

class Gradients {
  public:
    Gradients(const ParticleSet& set, const PairSettings& settings, const Arrangement& arrangement = {})
        : set_(set), settings_(settings), crowd_(set, settings, arrangement), by_id_(crowd_.particles()) {
        if (settings.several_fluids)
            fill(Field::fluid_number, [](std::size_t id, int) { return static_cast<double>(id % 2); });
    }

    /// value_of(id, axis), for all particles that have the field, copies included.
    template <class ValueOf>
    void fill(Field field, const ValueOf& value_of) {
        for (std::size_t id = 0; id < by_id_.size(); ++id)
            if (by_id_.group(id).has(field))
                for (int axis = 0; axis < by_id_.group(id).axes(field); ++axis)
                    by_id_.value(field, id, axis) = value_of(id, axis);
        crowd_.exchange({field});
    }

    [[nodiscard]] std::vector<Found> sweep() {
        for (const ClusterChoice part : {ClusterChoice::inner, ClusterChoice::border})
            crowd_.sweeps().gradients(crowd_.particles(), crowd_.list(), ArrangedCrowd::body_acceleration, part);
        std::vector<Found> all(by_id_.size());
        for (std::size_t id = 0; id < all.size(); ++id) {
            if (!is_fluid(id)) continue;
            const int d = set_.dimension;
            for (int k = 0; k < d * d; ++k)
                all[id].velocity_gradient(k / d, k % d) = by_id_.value(Field::velocity_gradient, id, k);
            all[id].density_gradient = by_id_.vector(Field::next_density_gradient, id);
            all[id].shift = by_id_.vector(Field::shift, id);
            all[id].off_walls = by_id_.vector(Field::off_walls, id);
            all[id].rate = by_id_.value(Field::density_rate, id);
            all[id].correction = by_id_.value(Field::mean_correction, id);
        }
        return all;
    }

    [[nodiscard]] bool is_fluid(std::size_t id) const { return set_.kind(id) == PartKind::fluid; }
    [[nodiscard]] const ById& by_id() const { return by_id_; }
    [[nodiscard]] ParticleStore& particles() { return crowd_.particles(); }
    [[nodiscard]] const PairSweeps& sweeps() const { return crowd_.sweeps(); }

  private:
    const ParticleSet& set_;
    PairSettings settings_;
    ArrangedCrowd crowd_;
    ById by_id_;
};

/// Plain sums over all pairs, in the words of models/sph/velocity_gradient.hpp.
std::vector<Found> of_all_pairs(Gradients& gradients, const ParticleSet& set, const PairSettings& settings) {
    struct Sum {
        Matrix m = Matrix::Zero(), a_of_rate = Matrix::Zero(), m_own = Matrix::Zero(), a_own = Matrix::Zero();
        Vec r = Vec::Zero(), shift = Vec::Zero(), off_walls = Vec::Zero();
        double diffusion = 0;
    };
    std::vector<Sum> sums(set.size());
    const ById& by_id = gradients.by_id();
    const Vec g(ArrangedCrowd::body_acceleration[0], ArrangedCrowd::body_acceleration[1],
                set.dimension == 3 ? ArrangedCrowd::body_acceleration[2] : 0);
    const double c0 = settings.sound_speed;
    const auto surface_gradient = [&](std::size_t id) {
        Matrix gradient = Matrix::Zero();
        for (int k = 0; k < set.dimension * set.dimension; ++k)
            gradient(k / set.dimension, k % set.dimension) = by_id.value(Field::surface_gradient, id, k);
        return gradient;
    };
    for_all_pairs(gradients.particles(), settings.support, [&](const Meeting& p) {
        if (!gradients.is_fluid(p.i)) return;
        const auto of = [&](Field field, std::size_t id) { return by_id.value(field, id); };
        const double weight = of(Field::volume, p.j) * gradients.sweeps().kernel_slope(p.separation.norm());
        Sum& sum = sums[p.i];
        Vec past = by_id.vector(Field::velocity, p.i) - by_id.vector(Field::velocity, p.j);
        Vec past_in_rate = past;
        double same = 1, difference = 0;
        if (gradients.is_fluid(p.j)) {
            if (settings.several_fluids) same = of(Field::fluid_number, p.i) == of(Field::fluid_number, p.j) ? 1 : 0;
            difference = of(Field::density, p.i) - of(Field::density, p.j);
            const Vec slopes = by_id.vector(Field::density_gradient, p.i) + by_id.vector(Field::density_gradient, p.j);
            sum.diffusion += same * weight * (difference - 0.5 * slopes.dot(p.separation));
        } else {
            difference = of(Field::density, p.i) * g.dot(p.separation) / (c0 * c0);
            Matrix before = Matrix::Zero();
            for (int k = 0; k < set.dimension * set.dimension; ++k)
                before(k / set.dimension, k % set.dimension) = gradient_before(p.i, k);
            const bool is_wall = set.kind(p.j) == PartKind::rigid, slides = settings.walls.sliding && is_wall;
            if (slides) past_in_rate = by_id.vector(Field::velocity, p.i) - by_id.vector(Field::wall_motion, p.j);
            past_in_rate *= 2;  // as in the pressure force, where p_j = p_i
            if (settings.free_surface) {
                // the partner of the pressure force alone
            } else if (slides && of(Field::wall_sliding, p.j) == 1) {
                const Vec normal = by_id.vector(Field::wall_normal, p.j);
                const Matrix across = normal * normal.transpose(), along = Matrix::Identity() - across;
                past_in_rate =
                    across * (past_in_rate - before * along * p.separation) + along * before * across * p.separation;
            } else {
                past_in_rate -= 0.5 * (before - before.transpose()) * p.separation;
            }
            if (is_wall) {  // the velocity on the line through the fluid's, half a spacing off or more, and the wall's
                const Vec normal = by_id.vector(Field::wall_normal, p.j);
                const double depth = of(Field::wall_distance, p.j), above = normal.dot(p.separation);
                const double actual = std::max(above - depth, 0.0), distance = std::max(actual, 0.5 * settings.spacing);
                Vec past_surface = past + (distance - actual) * before * normal;
                if (slides) past_surface -= surface_gradient(p.j) * (p.separation - above * normal);
                past += depth / distance * past_surface;
                sum.off_walls -= weight * p.separation;
            }
        }
        sum.m -= weight * p.separation * p.separation.transpose();
        sum.a_of_rate -= weight * past_in_rate * p.separation.transpose();
        sum.m_own -= same * weight * p.separation * p.separation.transpose();
        sum.a_own -= same * weight * past * p.separation.transpose();
        sum.r -= same * weight * difference * p.separation;
        const double ratio =
            gradients.sweeps().kernel_value(p.separation.norm()) / gradients.sweeps().kernel_value(settings.spacing);
        sum.shift += weight * (1 + 0.2 * std::pow(ratio, 4)) * p.separation;
    });
    const auto inverse = [&](Matrix m, double smallest) -> Matrix {
        if (set.dimension == 2) m(2, 2) = 1;
        return m.determinant() < smallest ? Matrix(Matrix::Identity()) : Matrix(m.inverse());
    };
    std::vector<Found> all(set.size());
    for (std::size_t id = 0; id < all.size(); ++id) {
        if (!gradients.is_fluid(id)) continue;
        const Sum& sum = sums[id];
        const Matrix b = inverse(sum.m, 0.3), b_own = inverse(sum.m_own, 0.03);
        all[id].velocity_gradient = sum.a_own * b_own;
        all[id].density_gradient = b_own * sum.r;
        all[id].off_walls = sum.off_walls * settings.spacing / std::max(sum.off_walls.norm() * settings.spacing, 0.1);
        all[id].shift = sum.shift;
        if (settings.free_surface) all[id].shift *= std::clamp(4.0 / set.dimension * sum.m.trace() - 3, 0.0, 1.0);
        all[id].rate = -by_id.value(Field::density, id) *
                           (settings.free_surface ? sum.a_of_rate : Matrix(sum.a_of_rate * b)).trace() +
                       settings.density.diffusion * settings.support * c0 * sum.diffusion;
        all[id].correction = b.topLeftCorner(set.dimension, set.dimension).trace() / set.dimension;
    }
    return all;
}

class GradientSweepIn : public testing::TestWithParam<std::tuple<int, bool>> {
  protected:
    const int dimension = std::get<0>(GetParam());
    const bool several = std::get<1>(GetParam());
    const ParticleSet set = crowd(dimension, {true, false, dimension == 3}, 3);
    PairSettings settings = corrected_settings(set, several);

    void expect_the_sums_of_all_pairs() const;
};

void GradientSweepIn::expect_the_sums_of_all_pairs() const {
    for (const VectorUnit unit : available_vector_units()) {
        SCOPED_TRACE(to_string(unit));
        Gradients gradients(set, settings, {.vector_unit = unit});
        gradients.fill(Field::density_gradient,
                       [](std::size_t id, int axis) { return 3.0 * axis - static_cast<double>(id % 5); });
        gradients.fill(Field::velocity_gradient, gradient_before);
        gradients.fill(Field::wall_sliding, [](std::size_t id, int) { return static_cast<double>(id % 2); });
        gradients.fill(Field::surface_gradient,
                       [](std::size_t id, int k) { return 0.2 * k - 0.1 * static_cast<double>(id % 4); });
        gradients.fill(Field::wall_motion,
                       [](std::size_t id, int axis) { return 0.1 * axis + 0.01 * static_cast<double>(id % 3); });
        const std::vector<Found> found = gradients.sweep(), expected = of_all_pairs(gradients, set, settings);
        for (std::size_t id = 0; id < found.size(); ++id) {
            SCOPED_TRACE(id);
            // Particles that are shaken this much have moments far from 1: their inverses are large.
            EXPECT_LT((found[id].velocity_gradient - expected[id].velocity_gradient).norm(),
                      1e-8 * (1 + expected[id].velocity_gradient.norm()));
            EXPECT_LT((found[id].density_gradient - expected[id].density_gradient).norm(),
                      1e-8 * (1 + expected[id].density_gradient.norm()));
            EXPECT_LT((found[id].shift - expected[id].shift).norm(), 1e-10 * (1 + expected[id].shift.norm()));
            EXPECT_LT((found[id].off_walls - expected[id].off_walls).norm(), 1e-10);
            EXPECT_NEAR(found[id].rate, expected[id].rate, 1e-8 * (1 + std::abs(expected[id].rate)));
            EXPECT_NEAR(found[id].correction, expected[id].correction, 1e-9 * expected[id].correction);
        }
    }
}

TEST_P(GradientSweepIn, sums_are_those_of_all_pairs) { expect_the_sums_of_all_pairs(); }

TEST_P(GradientSweepIn, sums_are_those_of_all_pairs_where_walls_slide) {
    settings.walls.sliding = true;
    expect_the_sums_of_all_pairs();
}

TEST_P(GradientSweepIn, sums_are_those_of_all_pairs_with_a_free_surface) {
    settings.free_surface = true;
    expect_the_sums_of_all_pairs();
}

TEST_P(GradientSweepIn, has_the_same_bits_in_any_arrangement) {
    const auto bits = [&](const Arrangement& arrangement) {
        Gradients gradients(set, settings, arrangement);
        gradients.fill(Field::velocity_gradient, gradient_before);
        std::vector<double> all;
        for (const Found& of : gradients.sweep()) {
            all.insert(all.end(), of.velocity_gradient.data(), of.velocity_gradient.data() + 9);
            all.insert(all.end(), of.density_gradient.data(), of.density_gradient.data() + 3);
            all.insert(all.end(), {of.rate, of.correction, of.shift[0], of.shift[1], of.shift[2]});
        }
        return all;
    };
    const std::vector<double> first = bits({});
    EXPECT_EQ(bits({.threads = 3, .extra_reach = 0.07, .near_only = true}), first);
    EXPECT_EQ(bits({.shuffled = 5, .wrapped = true}), first);
    for (const VectorUnit unit : available_vector_units()) {
        const std::vector<double> others = bits({.vector_unit = unit});
        ASSERT_EQ(others.size(), first.size());
        for (std::size_t k = 0; k < first.size(); ++k)
            EXPECT_EQ(others[k], first[k]) << "value " << k % 17 << " of particle " << k / 17;
    }
}

INSTANTIATE_TEST_SUITE_P(Variants, GradientSweepIn, testing::Combine(testing::Values(2, 3), testing::Bool()),
                         [](const auto& variant) {
                             return std::to_string(std::get<0>(variant.param)) + "d_" +
                                    (std::get<1>(variant.param) ? "several_fluids" : "one_fluid");
                         });

// The velocity differences that count in the density rate at solids (models/sph/velocity_gradient.hpp).

using Plane = simd::Vector<double, 2>;
using Gradient = simd::Vector<Plane, 2>;

Plane plane(double x, double y) {
    Plane v;
    v[0] = x;
    v[1] = y;
    return v;
}
Gradient rows(const Plane& x, const Plane& y) {
    Gradient g;
    g[0] = x;
    g[1] = y;
    return g;
}
void expect_near(const Plane& found, double x, double y) {
    EXPECT_NEAR(found[0], x, 1e-15);
    EXPECT_NEAR(found[1], y, 1e-15);
}

TEST(VelocityPastSolids, of_a_rigid_rotation_is_that_of_the_rotation) {
    const Plane x = plane(0.3, -0.2), past = plane(-2 * x[1], 2 * x[0]), normal = plane(0.6, 0.8);
    const Gradient g = rows(plane(0, -2), plane(2, 0));
    expect_near(models::VelocityGradient::past_solid(past, g, x), past[0], past[1]);
    expect_near(models::VelocityGradient::past_sliding_wall(past, g, x, normal, 0.0), past[0], past[1]);
}

TEST(VelocityPastSolids, of_a_shear_along_a_sliding_wall_is_that_of_the_shear) {
    const Plane x = plane(0.3, 0.2), normal = plane(0, 1);
    const Gradient g = rows(plane(0, 5), plane(0, 0));
    const Plane past = plane(7, 0);  // the wall's particles rest
    expect_near(models::VelocityGradient::past_sliding_wall(past, g, x, normal, 0.0), 5 * x[1], 0);
    expect_near(models::VelocityGradient::past_sliding_wall(past, g, x, normal, 1.0), 0, 0);
}

TEST(VelocityPastSolids, counts_an_approach_twice) {
    const Plane x = plane(0.3, 0.2), normal = plane(0, 1), past = plane(0, -1);
    const Gradient g = rows(plane(0, 0), plane(0, -4));
    expect_near(models::VelocityGradient::past_solid(past, g, x), 0, -2);
    expect_near(models::VelocityGradient::past_sliding_wall(past, g, x, normal, 0.0), 0, -2);
}

/// Fluid alone, shaken by a third of a spacing; inside, all gradients of linear fields must be exact.
class LinearFields : public testing::TestWithParam<int> {
  protected:
    static ParticleSet fluid_only(int dimension) {
        ParticleSet set = crowd(dimension, {false, false, false}, 7);
        for (std::size_t id = 0; id < set.size(); ++id) {
            set.part[id] = 0;
            set.body[id] = -1;
            set.fixed[id] = 0;
            set.wall_normal[id] = Vec::Zero();
            set.wall_distance[id] = 0;
        }
        return set;
    }
    const ParticleSet set = fluid_only(GetParam());
    [[nodiscard]] bool is_inside(std::size_t id) const {
        for (int axis = 0; axis < set.dimension; ++axis)
            if (set.position[id][axis] < 0.3 || set.position[id][axis] > set.box.high[axis] - 0.3) return false;
        return true;
    }
};

TEST_P(LinearFields, have_exact_gradients_and_a_density_rate_without_error) {
    PairSettings settings = corrected_settings(set, false);
    Gradients gradients(set, settings);
    Matrix g;
    g << 0.3, -1.1, 0.4, 0.9, 0.2, -0.6, 0.1, 0.8, -0.5;  // divergence 0 in 3-D, 0.5 in 2-D
    const Vec slope(40, -25, 13);
    gradients.fill(Field::velocity, [&](std::size_t id, int axis) {
        double v = 1.7;
        for (int b = 0; b < set.dimension; ++b) v += g(axis, b) * set.position[id][b];
        return v;
    });
    gradients.fill(Field::density, [&](std::size_t id, int) {
        double rho = 1000;
        for (int b = 0; b < set.dimension; ++b) rho += slope[b] * set.position[id][b];
        return rho;
    });
    gradients.fill(Field::density_gradient, [&](std::size_t, int axis) { return slope[axis]; });
    const std::vector<Found> found = gradients.sweep();
    int inside = 0;
    for (std::size_t id = 0; id < found.size(); ++id) {
        if (!is_inside(id)) continue;
        ++inside;
        const double divergence = g.topLeftCorner(set.dimension, set.dimension).trace();
        for (int a = 0; a < set.dimension; ++a) {
            EXPECT_NEAR(found[id].density_gradient[a], slope[a], 1e-7);
            for (int b = 0; b < set.dimension; ++b) EXPECT_NEAR(found[id].velocity_gradient(a, b), g(a, b), 1e-10);
        }
        EXPECT_NEAR(found[id].rate, -gradients.by_id().value(Field::density, id) * divergence, 1e-6);
    }
    EXPECT_GT(inside, 2);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, LinearFields, testing::Values(2, 3));

}  // namespace
}  // namespace dmp::tests::solver_gradient_sweep_tests
