// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

#include "solver/contact/surface_contact.hpp"
#include "solver/elastic/spring_bodies.hpp"

namespace dmp::solver {

/// Bodies that are held by contact and by films of liquid between them, as one matrix with its factors: a thin film is
/// so stiff that conjugate gradients which only know each body take hundreds of iterations. The pressures p of films
/// are unknowns of their own, so that it stays sparse,
///     | A + stiffness    films        | | w |   | r |
///     | films^T          -conductance | | p | = | 0 |
/// which has factors in any order, as A is positive and -conductance negative definite (Vanderbei 1995).
class ContactPreconditioner {
  public:
    /// Of bodies that may touch, as they are prepared, and the contact of the last w. Throws DivergenceError if it is
    /// not finite.
    void factorise(const SpringBodies& bodies, const SurfaceContact& contact);
    [[nodiscard]] bool is_ready() const { return is_ready_; }
    /// In place; 0 for what is held. Leaves bodies that do not touch as they are.
    void solve(std::span<Vec> values) const;

  private:
    int dimension_ = 0;
    bool is_ready_ = false;
    std::vector<int> unknown_;  ///< by unknown of bodies and axis
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace dmp::solver
