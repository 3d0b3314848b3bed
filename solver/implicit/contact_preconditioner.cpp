// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/implicit/contact_preconditioner.hpp"

#include "base/errors.hpp"

namespace dmp::solver {

namespace {

/// Of unknowns: which do not move, and those of bodies that do not touch.
constexpr int none = -1, elsewhere = -2;

}  // namespace

void ContactPreconditioner::factorise(const SpringBodies& bodies, const SurfaceContact& contact) {
    const ContactMatrix held = contact.matrix();
    dimension_ = contact.dimension();
    std::vector<Eigen::Triplet<double>> entries;
    unknown_.clear();
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b) {
        const SpringBody& body = *bodies.bodies()[b];
        const bool touches = contact.touched_bodies()[b];
        if (touches) body.add_prepared(static_cast<int>(unknown_.size()), entries);
        unknown_.insert(unknown_.end(), body.unknowns() * static_cast<std::size_t>(dimension_),
                        touches ? none : elsewhere);
    }
    int unknowns = 0;
    for (const auto& entry : entries)
        if (int& unknown = unknown_[static_cast<std::size_t>(entry.row())]; unknown == none) unknown = unknowns++;
    for (auto& entry : entries)
        entry = {unknown_[static_cast<std::size_t>(entry.row())], unknown_[static_cast<std::size_t>(entry.col())],
                 entry.value()};

    const auto unknown_of = [&](Eigen::Index row) { return unknown_[static_cast<std::size_t>(row)]; };
    const auto add = [&](const Eigen::SparseMatrix<double>& matrix, const auto& place) {
        for (int column = 0; column < matrix.outerSize(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
                if (const auto [a, b] = place(entry.row(), entry.col()); a >= b && b >= 0)
                    entries.emplace_back(a, b, entry.value());
    };
    using At = std::pair<int, int>;
    add(held.stiffness, [&](Eigen::Index a, Eigen::Index b) { return At{unknown_of(a), unknown_of(b)}; });
    const int pressures = static_cast<int>(held.conductance.rows());
    if (pressures > 0) {
        // A pressure comes after all velocities.
        add(Eigen::SparseMatrix<double>(held.films.transpose()), [&](Eigen::Index a, Eigen::Index b) {
            return At{unknowns + static_cast<int>(a), unknown_of(b)};
        });
        add(-held.conductance, [&](Eigen::Index a, Eigen::Index b) {
            return At{unknowns + static_cast<int>(a), unknowns + static_cast<int>(b)};
        });
    }
    Eigen::SparseMatrix<double> matrix(unknowns + pressures, unknowns + pressures);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
    if (solver_.info() != Eigen::Success)
        throw DivergenceError("the stiffness of elastic bodies that touch is no longer finite",
                              "lower numerics.step_factor or check the drive");
    is_ready_ = true;
}

void ContactPreconditioner::solve(std::span<Vec> values) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(solver_.rows());
    const auto axes = static_cast<std::size_t>(dimension_);
    for (std::size_t k = 0; k < unknown_.size(); ++k)
        if (unknown_[k] >= 0) right[unknown_[k]] = values[k / axes][static_cast<Eigen::Index>(k % axes)];
    const Eigen::VectorXd solution = solver_.solve(right);
    for (std::size_t k = 0; k < unknown_.size(); ++k)
        if (unknown_[k] != elsewhere)
            values[k / axes][static_cast<Eigen::Index>(k % axes)] = unknown_[k] != none ? solution[unknown_[k]] : 0;
}

}  // namespace dmp::solver
