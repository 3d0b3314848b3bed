// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <limits>

#include <gtest/gtest.h>

#include "solver/implicit/conjugate_gradients.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_conjugate_gradients_tests {
namespace {

/// A matrix that is written down, preconditioned with its diagonal; the error is the residual's length.
struct SmallSystem {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right, x = Eigen::VectorXd::Zero(right.size());
    Eigen::VectorXd residual{}, direction{};

    [[nodiscard]] Eigen::VectorXd preconditioned() const { return residual.cwiseQuotient(matrix.diagonal()); }
    [[nodiscard]] Residual now() const { return {residual.dot(preconditioned()), residual.norm()}; }
    Residual start() {
        residual = right - matrix * x;
        direction = preconditioned();
        return now();
    }
    [[nodiscard]] double curvature() const { return direction.dot(matrix * direction); }
    Residual step(double alpha) {
        x += alpha * direction;
        residual -= alpha * (matrix * direction);
        return now();
    }
    void turn(double beta) { direction = preconditioned() + beta * direction; }
};

/// Springs between neighbours on a line, of unlike strength, and each on the ground.
SmallSystem chain() {
    constexpr int count = 7;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(count, count);
    for (int i = 0; i + 1 < count; ++i) {
        const double strength = 1 + 50 * i;
        matrix(i, i) += strength;
        matrix(i + 1, i + 1) += strength;
        matrix(i, i + 1) -= strength;
        matrix(i + 1, i) -= strength;
    }
    return {matrix, Eigen::VectorXd::LinSpaced(count, -1, 2)};
}

TEST(ConjugateGradients, solve_in_as_many_iterations_as_there_are_unknowns) {
    SmallSystem system = chain();
    const auto end = conjugate_gradients(system, 1e-11, 100);
    EXPECT_TRUE(end.converged);
    EXPECT_LE(end.error, 1e-11);
    EXPECT_LE(end.iterations, 8);
    EXPECT_GE(end.iterations, 5);
    const Eigen::VectorXd expected = system.matrix.llt().solve(system.right);
    EXPECT_LT((system.x - expected).norm(), 1e-11 * expected.norm());
}

TEST(ConjugateGradients, do_nothing_to_a_solution) {
    SmallSystem system = chain();
    system.x = system.matrix.llt().solve(system.right);
    const Eigen::VectorXd before = system.x;
    const auto end = conjugate_gradients(system, 1e-10, 100);
    EXPECT_TRUE(end.converged);
    EXPECT_EQ(end.iterations, 0);
    EXPECT_EQ(system.x, before);
}

TEST(ConjugateGradients, start_from_what_is_there) {
    SmallSystem system = chain(), from_near = chain();
    from_near.x = 1.001 * system.matrix.llt().solve(system.right);
    const double error = conjugate_gradients(system, 1e-11, 3).error;
    EXPECT_GT(error, 0.01);
    EXPECT_NEAR(conjugate_gradients(from_near, 1e-11, 3).error / error, 0.001, 1e-8) << "the same way, in small";
}

TEST(ConjugateGradients, end_after_the_most_iterations) {
    SmallSystem system = chain();
    const auto end = conjugate_gradients(system, 1e-11, 2);
    EXPECT_FALSE(end.converged);
    EXPECT_EQ(end.iterations, 2);
    EXPECT_GT(end.error, 1e-11);
}

TEST(ConjugateGradients, end_where_the_matrix_is_not_positive_or_no_number) {
    SmallSystem negative = chain();
    negative.matrix -= 40 * Eigen::MatrixXd::Identity(7, 7);
    EXPECT_FALSE(conjugate_gradients(negative, 1e-11, 100).converged);
    SmallSystem none = chain();
    none.right[3] = std::numeric_limits<double>::quiet_NaN();
    const auto end = conjugate_gradients(none, 1e-11, 100);
    EXPECT_FALSE(end.converged);
    EXPECT_EQ(end.iterations, 0);
}

}  // namespace
}  // namespace dmp::tests::solver_conjugate_gradients_tests
