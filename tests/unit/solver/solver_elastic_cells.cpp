// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The laws of elastic solids, and one cell of them, against closed forms and numerical derivatives.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "models/elastic/elastic_cell.hpp"
#include "models/elastic/elastic_laws.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_elastic_cells_tests {
namespace {

constexpr double pi = std::numbers::pi;
constexpr LameConstants some_constants{3.0, 2.0};

class RandomNumbers {
  public:
    double operator()(double largest) { return std::uniform_real_distribution(-largest, largest)(generator_); }
    template <class Values>
    Values of(double largest) {
        Values values;
        for (auto& value : values.reshaped()) value = (*this)(largest);
        return values;
    }

  private:
    std::mt19937_64 generator_{7};
};

/// Calls check.operator()<Law, D>() for each law in 2-D and 3-D.
template <class Check>
void for_each_law(const Check& check) {
    for (std::size_t number = 0; number < ElasticLaws::size; ++number)
        ElasticLaw(number).visit([&]<class Law>() {
            SCOPED_TRACE(Law::facts.key);
            check.template operator()<Law, 2>();
            check.template operator()<Law, 3>();
        });
}

/// dS/dE by central differences of a law's stress with respect to Green's strain, shears twice.
template <class Law, int D>
typename Voigt<D>::Square numerical_tangent(const Law& law, const Matrix<D>& c) {
    typename Voigt<D>::Square tangent;
    const double d = 1e-6;
    for (int column = 0; column < Voigt<D>::size; ++column) {
        const auto [i, j] = Voigt<D>::axes[column];
        Matrix<D> change = Matrix<D>::Zero();  // of C = 1 + 2 E: of 2 E_ij = 2 d, both components of C change by 2 d
        change(i, j) = change(j, i) = i == j ? 2 * d : d;
        const Matrix<D> difference =
            (law.template stress<D>(c + change) - law.template stress<D>(c - change)) / (2 * d);
        for (int row = 0; row < Voigt<D>::size; ++row)
            tangent(row, column) = difference(Voigt<D>::axes[row][0], Voigt<D>::axes[row][1]);
    }
    return tangent;
}

TEST(ElasticLaws, are_hookes_law_for_small_strains) {
    for_each_law([]<class Law, int D>() {
        const Law law{some_constants};
        const Matrix<D> at_rest = Matrix<D>::Identity();
        EXPECT_EQ(law.template energy<D>(at_rest), 0);
        EXPECT_EQ(law.template stress<D>(at_rest).norm(), 0);
        EXPECT_LT((law.template tangent<D>(at_rest) - some_constants.tangent<D>()).norm(), 1e-14);
        EXPECT_LT((numerical_tangent<Law, D>(law, at_rest) - some_constants.tangent<D>()).norm(), 1e-8);
    });
}

TEST(ElasticLaws, stress_is_the_derivative_of_the_energy) {
    RandomNumbers random;
    for_each_law([&]<class Law, int D>() {
        const Law law{some_constants};
        const Matrix<D> f = Matrix<D>::Identity() + random.of<Matrix<D>>(0.2), c = f.transpose() * f;
        const Matrix<D> stress = law.template stress<D>(c);
        const double d = 1e-6;
        for (const auto& [i, j] : Voigt<D>::axes) {
            Matrix<D> change = Matrix<D>::Zero();
            change(i, j) += d;
            change(j, i) += d;  // on the diagonal twice: dE = change / 2
            const double rate = (law.template energy<D>(c + change) - law.template energy<D>(c - change)) / (2 * d);
            EXPECT_NEAR(rate, stress(i, j), 1e-7);
        }
    });
}

TEST(ElasticLaws, tangent_is_that_of_the_stress_where_all_of_it_is_positive) {
    RandomNumbers random;
    for_each_law([&]<class Law, int D>() {
        const Law law{some_constants};
        const Matrix<D> f = 0.9 * Matrix<D>::Identity() + random.of<Matrix<D>>(0.1), c = f.transpose() * f;
        EXPECT_LT((law.template tangent<D>(c) - numerical_tangent<Law, D>(law, c)).norm(), 1e-6);
    });
}

TEST(NeoHookean, resists_being_pressed_to_nothing_and_saint_venant_does_not) {
    const auto energy = []<class Law>(double share) {
        return Law{some_constants}.template energy<2>(share * share * Matrix<2>::Identity());
    };
    EXPECT_LT(energy.operator()<SaintVenantKirchhoff>(1e-6), 2.5);
    EXPECT_GT(energy.operator()<NeoHookean>(1e-6), 200);
}

/// A cell of which the solid fills a part.
template <int D>
ElasticCell<D> cut_cell(double nu) {
    using Point = typename ElasticCell<D>::Point;
    Point size, centroid, moment;
    for (int axis = 0; axis < D; ++axis) {
        size[axis] = 0.5 + 0.1 * axis;
        centroid[axis] = 0.05 * (axis + 1);
        moment[axis] = size[axis] * size[axis] / (14 + axis);
    }
    return {size, centroid, 0.6 * size.prod(), moment, 10, nu};
}

template <int D>
typename ElasticCell<D>::Corners corners_at_rest(const typename ElasticCell<D>::Point& size) {
    typename ElasticCell<D>::Corners corners;
    for (int k = 0; k < ElasticCell<D>::corners; ++k)
        for (int axis = 0; axis < D; ++axis) corners(axis, k) = (k >> axis & 1 ? 0.5 : -0.5) * size[axis];
    return corners;
}

template <int D>
typename ElasticCell<D>::Corners corners_of_cut_cell() {
    typename ElasticCell<D>::Point size;
    for (int axis = 0; axis < D; ++axis) size[axis] = 0.5 + 0.1 * axis;
    return corners_at_rest<D>(size);
}

template <int D>
Matrix<D> some_turn() {
    if constexpr (D == 2)
        return Eigen::Rotation2Dd(2.3).toRotationMatrix();
    else
        return Eigen::AngleAxisd(pi, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
}

TEST(ElasticCell, has_the_strain_and_energy_of_an_affine_motion_where_it_is_cut) {
    RandomNumbers random;
    for_each_law([&]<class Law, int D>() {
        const auto cell = cut_cell<D>(0.3);
        const Law law{cell.constants()};
        const Matrix<D> f = Matrix<D>::Identity() + random.of<Matrix<D>>(0.2);
        const auto x = (f * corners_of_cut_cell<D>()).eval();
        EXPECT_LT((cell.gradient(x) - f).norm(), 1e-14);
        EXPECT_NEAR(cell.energy(law, x), cell.volume * law.template energy<D>(f.transpose() * f), 1e-13);
    });
}

TEST(ElasticCell, forces_are_minus_the_derivative_of_the_energy) {
    RandomNumbers random;
    for_each_law([&]<class Law, int D>() {
        using Corners = typename ElasticCell<D>::Corners;
        const auto cell = cut_cell<D>(0.3);
        const Law law{cell.constants()};
        const Corners x = some_turn<D>() * corners_of_cut_cell<D>() + random.of<Corners>(0.05);
        const Corners forces = cell.forces(law, 0, x, Corners::Zero());
        const double d = 1e-6;
        for (int k = 0; k < ElasticCell<D>::corners; ++k)
            for (int i = 0; i < D; ++i) {
                Corners ahead = x, behind = x;
                ahead(i, k) += d;
                behind(i, k) -= d;
                EXPECT_NEAR(forces(i, k), -(cell.energy(law, ahead) - cell.energy(law, behind)) / (2 * d), 1e-7);
            }
    });
}

TEST(ElasticCell, forces_have_no_resultant_and_no_moment) {
    RandomNumbers random;
    for_each_law([&]<class Law, int D>() {
        using Corners = typename ElasticCell<D>::Corners;
        const auto cell = cut_cell<D>(0.45);
        const Corners x = corners_of_cut_cell<D>() + random.of<Corners>(0.05), v = random.of<Corners>(1);
        const Corners forces = cell.forces(Law{cell.constants()}, 0.3, x, v);
        EXPECT_LT(forces.rowwise().sum().norm(), 1e-14 * forces.norm());
        const Matrix<D> moments = forces * x.transpose();
        EXPECT_LT((moments - moments.transpose()).norm(), 1e-14 * forces.norm());
    });
}

TEST(ElasticCell, is_free_of_force_however_it_is_turned_and_damping_knows_no_turning) {
    for_each_law([]<class Law, int D>() {
        using Corners = typename ElasticCell<D>::Corners;
        const auto cell = cut_cell<D>(0.3);
        const Law law{cell.constants()};
        const Corners x = some_turn<D>() * corners_of_cut_cell<D>();
        Matrix<D> spin = Matrix<D>::Zero();
        spin(0, 1) = 2;
        spin(1, 0) = -2;
        EXPECT_LT(cell.forces(law, 0, x, Corners::Zero()).norm(), 1e-13);
        EXPECT_LT(cell.forces(law, 10, x, spin * x).norm(), 1e-12);
    });
}

TEST(ElasticCell, damping_takes_energy) {
    RandomNumbers random;
    for_each_law([&]<class Law, int D>() {
        using Corners = typename ElasticCell<D>::Corners;
        const auto cell = cut_cell<D>(0.3);
        const Law law{cell.constants()};
        for (int n = 0; n < 20; ++n) {
            const Corners x = corners_of_cut_cell<D>() + random.of<Corners>(0.02), v = random.of<Corners>(1);
            const Corners damping = cell.forces(law, 0.5, x, v) - cell.forces(law, 0, x, v);
            EXPECT_LT(damping.cwiseProduct(v).sum(), 0);
        }
    });
}

TEST(ElasticCell, stiffness_at_rest_is_the_derivative_of_the_forces_and_is_never_negative) {
    RandomNumbers random;
    for_each_law([&]<class Law, int D>() {
        using Cell = ElasticCell<D>;
        using Corners = typename Cell::Corners;
        const auto cell = cut_cell<D>(0.3);
        const Law law{cell.constants()};
        const Corners rest = corners_of_cut_cell<D>();
        const auto stiffness = cell.stiffness(law, rest, 1, 0);
        const double d = 1e-6;
        for (int unknown = 0; unknown < Cell::unknowns; ++unknown) {
            Corners ahead = rest, behind = rest;
            ahead(unknown % D, unknown / D) += d;
            behind(unknown % D, unknown / D) -= d;
            const Corners rate =
                (cell.forces(law, 0, behind, Corners::Zero()) - cell.forces(law, 0, ahead, Corners::Zero())) / (2 * d);
            EXPECT_LT((stiffness.col(unknown) - rate.reshaped()).norm(), 1e-7);
        }
        EXPECT_LT((cell.stiffness(law, rest, 0, 1) - stiffness).norm(), 1e-12);
        for (int n = 0; n < 20; ++n) {
            const Corners x = rest + random.of<Corners>(0.1);
            const Eigen::SelfAdjointEigenSolver<typename Cell::Square> modes(cell.stiffness(law, x, 1, 0.1));
            EXPECT_GT(modes.eigenvalues().minCoeff(), -1e-12 * modes.eigenvalues().maxCoeff());
        }
    });
}

TEST(ElasticCell, has_no_motion_without_force_but_those_of_a_rigid_body) {
    for_each_law([]<class Law, int D>() {
        using Cell = ElasticCell<D>;
        const auto cell = cut_cell<D>(0.3);
        const Eigen::SelfAdjointEigenSolver<typename Cell::Square> modes(
            cell.stiffness(Law{cell.constants()}, corners_of_cut_cell<D>(), 1, 0));
        const auto values = modes.eigenvalues();
        const auto rigid = (values.array() < 1e-10 * values.maxCoeff()).count();
        EXPECT_EQ(rigid, D == 2 ? 3 : 6);
    });
}

/// Energy of a beam along x of n cells across, cubes, per length, in the pure bending of curvature kappa about z, over
/// E' I kappa^2 / 2; in 3-D the beam is as deep as it is thick, and free to contract sideways.
template <int D>
double bending_over_exact(int n, double nu) {
    using Cell = ElasticCell<D>;
    using Point = typename Cell::Point;
    const double a = 1.0 / n, e = 10, kappa = 1e-5;
    const Point size = Point::Constant(a), moment = Point::Constant(a * a / 12);
    const double sideways = D == 2 ? nu / (1 - nu) : nu;
    double energy = 0;
    for (int row = 0; row < n; ++row)
        for (int layer = 0; layer < (D == 3 ? n : 1); ++layer) {
            const Cell cell(size, Point::Zero(), size.prod(), moment, e, nu);
            typename Cell::Corners x = corners_at_rest<D>(size);
            for (int k = 0; k < Cell::corners; ++k) {
                const double along = x(0, k), y = x(1, k) + (row + 0.5) * a - 0.5;
                const double z = D == 3 ? x(D - 1, k) + (layer + 0.5) * a - 0.5 : 0;
                x(0, k) += kappa * along * y;
                x(1, k) += -kappa * (along * along + sideways * (y * y - (D == 3 ? z * z : 0))) / 2;
                if constexpr (D == 3) x(2, k) += -kappa * sideways * y * z;
            }
            energy += cell.energy(SaintVenantKirchhoff{cell.constants()}, x) / a;
        }
    const double stiffness = D == 2 ? e / (1 - nu * nu) / 12 : e / 12;
    return energy / (0.5 * stiffness * kappa * kappa);
}

TEST(ElasticCell, bends_exactly_with_any_number_across_and_any_poisson_ratio) {
    for (const double nu : {0.0, 0.25, 0.4, 0.49})
        for (const int n : {1, 2, 4, 8}) {
            EXPECT_NEAR(bending_over_exact<2>(n, nu), 1, 2e-4) << n << " across, nu " << nu;
            EXPECT_NEAR(bending_over_exact<3>(n, nu), 1, 2e-4) << n << " across, nu " << nu;
        }
}

TEST(ElasticCell, says_cauchys_stress) {
    // Stretched by 1.1 along x and turned: sigma = F S F^T / J by hand.
    const ElasticCell<2> cell({1, 1}, {0, 0}, 1, {1.0 / 12, 1.0 / 12}, 10, 0.25);
    const Matrix<2> turn = Eigen::Rotation2Dd(0.5).toRotationMatrix();
    Matrix<2> stretch = Matrix<2>::Identity();
    stretch(0, 0) = 1.1;
    const LameConstants of = cell.constants();
    const double strain = (1.1 * 1.1 - 1) / 2;
    Matrix<2> in_plane = Matrix<2>::Zero();
    in_plane(0, 0) = 1.1 * 1.1 * (of.lambda + 2 * of.mu) * strain / 1.1;
    in_plane(1, 1) = of.lambda * strain / 1.1;
    Matrix<3> expected = Matrix<3>::Zero();
    expected.topLeftCorner<2, 2>() = turn * in_plane * turn.transpose();
    expected(2, 2) = of.lambda * strain / 1.1;  // plane strain
    const auto x = (turn * stretch * corners_at_rest<2>({1, 1})).eval();
    EXPECT_LT((cell.stress(SaintVenantKirchhoff{of}, x) - expected).norm(), 1e-14);
    EXPECT_NEAR(cell.principal_strains(x)[1], strain, 1e-14);
    EXPECT_NEAR(cell.principal_strains(x)[0], 0, 1e-14);
}

}  // namespace
}  // namespace dmp::tests::solver_elastic_cells_tests
