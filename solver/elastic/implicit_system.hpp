// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <cmath>
#include <span>
#include <vector>

#include "solver/elastic/spring_network.hpp"

namespace dmp::solver {

/// The matrix of one implicit midpoint step of a spring body, for the velocities of its free nodes at mid-step:
///   A = M + dt/2 (C + k_v) + dt^2/4 K
/// with K and C of every spring along its own direction of stretch or turning (Gauss-Newton), and in K what springs
/// under tension resist sideways: all terms of the exact stiffness that are positive for certain, so that A is
/// symmetric and positive definite in any state. It is factorised again only when corrections no longer converge fast.
template <int D>
class SpringNetwork<D>::ImplicitSystem {
  public:
    explicit ImplicitSystem(const SpringNetwork& body);

    /// True when the present factors serve for a step dt: corrections then converge nearly as fast as with its own.
    [[nodiscard]] bool fits(double dt) const { return std::abs(dt - dt_) < 1e-2 * dt_; }
    void factorise(const SpringNetwork& body, const Vectors& position, double dt) { factorise(body, position, dt, {}); }
    /// Factors of A plus `more` on the diagonal, by node and axis [kg]; none: of A.
    void factorise(const SpringNetwork& body, const Vectors& position, double dt, std::span<const Vec> more);
    /// values = scale A values, and values = scale (A + more)^-1 values; 0 for fixed nodes.
    void multiply(std::span<Vec> values, double scale) const;
    void solve(std::span<Vec> values, double scale) const;
    /// The factors are what the past made them, and results depend on them in their last bits: they are made again from
    /// the state they came from.
    void archive(Archive& file, const std::string& name, const SpringNetwork& body);

    /// Solves A dv = residual, adds dv to the velocities and dt/2 dv to the positions of free nodes; returns the
    /// largest displacement [m].
    double correct(const Vectors& residual, double dt, Vectors& position, Vectors& velocity);

  private:
    using Matrix = Eigen::SparseMatrix<double>;

    /// A += weight g g^T for the slope g of a length or an angle along the arms of a spring.
    template <class Law, class Slope>
    void add(const LocalSpring<Law>& spring, const Slope& slope, double weight);
    [[nodiscard]] double& entry(int row, int column);
    template <class Map>
    void change(std::span<Vec> values, double scale, const Map& map) const;

    std::vector<int> unknown_;  ///< node -> its first unknown, -1 when fixed
    Matrix matrix_;             ///< lower triangle
    Eigen::SimplicialLLT<Matrix> solver_;
    double dt_ = -1;
    Vectors position_;  ///< that the factors were made for
};

}  // namespace dmp::solver
