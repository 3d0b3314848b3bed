// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "solver/time/spring_bodies.hpp"

namespace dmp {

/// The matrix of one implicit midpoint step of a spring body, for the velocities of its free nodes at mid-step:
///   A = M + dt/2 (C + k_v) + dt^2/4 K
/// with K and C in Gauss-Newton form (every bond and hinge along its own direction of stretch or turning, without the
/// terms of its present tension), which is symmetric and positive definite in any state. It is factorised again only
/// when corrections no longer converge fast.
class SpringBody::ImplicitSystem {
  public:
    explicit ImplicitSystem(const SpringBody& body);

    /// True when the present factors serve for a step dt: corrections then converge nearly as fast as with its own.
    [[nodiscard]] bool fits(double dt) const { return std::abs(dt - dt_) < 1e-2 * dt_; }
    void factorise(const SpringBody& body, const Vectors& position, double dt) { factorise(body, position, dt, {}); }
    /// Factors of A plus `more` on the diagonal, by node and axis [kg]; none: of A.
    void factorise(const SpringBody& body, const Vectors& position, double dt, std::span<const Vector<double, 2>> more);
    /// values = scale A values, and values = scale (A + more)^-1 values; 0 for fixed nodes.
    void multiply(std::span<Vector<double, 2>> values, double scale) const;
    void solve(std::span<Vector<double, 2>> values, double scale) const;
    /// The factors are what the past made them, and results depend on them in their last bits: they are made again from
    /// the state they came from.
    void archive(Archive& file, const std::string& name, const SpringBody& body);

    /// Solves A dv = residual, adds dv to the velocities and dt/2 dv to the positions of free nodes; returns the
    /// largest displacement [m].
    double correct(const Vectors& residual, double dt, Vectors& position, Vectors& velocity);

  private:
    using Matrix = Eigen::SparseMatrix<double>;
    using Gradient = std::array<Vector<double, 2>, 3>;

    /// A += weight g g^T for the gradient g of a length or an angle with respect to `count` nodes.
    void add(const std::array<int, 3>& nodes, int count, const Gradient& gradient, double weight);
    [[nodiscard]] double& entry(int row, int column);
    template <class Map>
    void change(std::span<Vector<double, 2>> values, double scale, const Map& map) const;

    std::vector<int> unknown_;  ///< node -> its first unknown, -1 when fixed
    Matrix matrix_;             ///< lower triangle
    Eigen::SimplicialLLT<Matrix> solver_;
    double dt_ = -1;
    Vectors position_;  ///< that the factors were made for
};

}  // namespace dmp
