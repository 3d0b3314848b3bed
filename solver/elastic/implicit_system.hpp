// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <cmath>
#include <span>
#include <vector>

#include "solver/elastic/spring_network.hpp"

namespace dmp::solver {

/// The matrix of one implicit midpoint step of an elastic body, for the velocities of its free nodes at mid-step:
///   A = M + dt/2 (C + k_v) + dt^2/4 K
/// K and C include each spring along the gradient of its length or angle (Gauss-Newton), and K the lateral stiffness
/// of springs and cells under tension: all terms of the exact stiffness that are guaranteed to be positive, so that A
/// is symmetric and positive definite in any state. It is factorised again only when corrections no longer converge
/// fast.
template <int D>
class SpringNetwork<D>::ImplicitSystem {
  public:
    explicit ImplicitSystem(const SpringNetwork& body);

    /// True if the present factors can be used for a step dt: corrections then converge nearly as fast as with
    /// factors for dt.
    [[nodiscard]] bool fits(double dt) const { return std::abs(dt - dt_) < 1e-2 * dt_; }
    void factorise(const SpringNetwork& body, const Vectors& position, double dt) { factorise(body, position, dt, {}); }
    /// Factorises A plus `more` on the diagonal, by node and axis [kg]; if empty, A.
    void factorise(const SpringNetwork& body, const Vectors& position, double dt, std::span<const Vec> more);
    /// values = scale A values, and values = scale (A + more)^-1 values; 0 for fixed nodes.
    void multiply(std::span<Vec> values, double scale) const;
    void solve(std::span<Vec> values, double scale) const;
    /// Adds the lower triangle of scale (A + more) to the entries, in the rows `first` + D node + axis.
    void add_factorised(int first, double scale, std::vector<Eigen::Triplet<double>>& entries) const;
    /// The factors depend on the history of the run, and the last bits of results depend on them: loading recomputes
    /// them from the state they were computed from.
    void archive(Archive& file, const std::string& name, const SpringNetwork& body);

    /// Solves A dv = residual, adds dv to the velocities and dt/2 dv to the positions of free nodes; returns the
    /// largest displacement [m].
    double correct(const Vectors& residual, double dt, Vectors& position, Vectors& velocity);

  private:
    using Matrix = Eigen::SparseMatrix<double>;

    /// A += weight g g^T for the slope g of a length or an angle along the arms of a spring.
    template <class Law, class Slope>
    void add(const LocalSpring<D, Law>& spring, const Slope& slope, double weight);
    void add(const LocalCell<D>& cell, const typename LocalCell<D>::Element::Square& stiffness);
    [[nodiscard]] double& entry(int row, int column);
    template <class Map>
    void change(std::span<Vec> values, double scale, const Map& map) const;

    /// Of a node along an axis; -1 where it is held.
    [[nodiscard]] int unknown(std::size_t node, int axis) const { return unknown_[node * D + axis]; }
    [[nodiscard]] std::size_t nodes() const { return unknown_.size() / D; }
    /// Calls visit(node, axis, unknown) for each.
    template <class Visit>
    void for_each_unknown(const Visit& visit) const {
        for (std::size_t node = 0; node < nodes(); ++node)
            for (int axis = 0; axis < D; ++axis)
                if (const int number = unknown(node, axis); number >= 0) visit(node, axis, number);
    }
    /// Adds to the entry of two unknowns in the lower triangle; nothing where one is none.
    void add(int row, int column, double value) {
        if (column >= 0 && row >= column) entry(row, column) += value;
    }

    std::vector<int> unknown_;  ///< by node and axis
    Matrix matrix_;             ///< lower triangle
    Eigen::VectorXd more_;      ///< on the diagonal of the factors
    Eigen::SimplicialLLT<Matrix> solver_;
    double dt_ = -1;
    Vectors position_;  ///< for which the factors were computed
};

}  // namespace dmp::solver
