// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "scene/scene.hpp"
#include "solver/elastic/spring_network.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// A set with one elastic solid 'beam' and nodes of these masses, and nothing between them yet.
inline ParticleSet set_of_nodes(int dimension, const std::vector<Vec>& position, const std::vector<double>& mass) {
    ParticleSet set;
    set.dimension = dimension;
    set.spacing = 1;
    set.parts = {{"beam", PartKind::elastic}};
    set.position = position;
    set.mass = mass;
    set.volume.assign(position.size(), 1);
    set.part.assign(position.size(), 0);
    set.body.assign(position.size(), 0);
    set.fixed.assign(position.size(), 0);
    set.seated.assign(position.size(), 0);
    set.wall_normal.assign(position.size(), Vec::Zero());
    set.wall_distance.assign(position.size(), 0);
    set.box = {Vec::Constant(-1), Vec::Constant(1)};
    for (const Vec& at : position) {
        set.box.low = set.box.low.cwiseMin(at);
        set.box.high = set.box.high.cwiseMax(at);
    }
    return set;
}

inline Part part_with(double damping, double drag = 0) {
    Part part;
    part.name = std::string("beam");
    part.kind = PartKind::elastic;
    part.bond_damping = damping;
    part.drag = drag;
    return part;
}

/// The stiffness of a body, by central differences of its forces: nodes too far apart to share a spring are moved
/// together.
template <int D>
class NumericalStiffness {
  public:
    using Vectors = typename SpringNetwork<D>::Vectors;

    NumericalStiffness(const SpringNetwork<D>& body, const ParticleSet& set) : body_(body), set_(set) {
        const auto widen = [&](int a, int b) { reach_ = std::max(reach_, (set.position[a] - set.position[b]).norm()); };
        for (const Bond& bond : set.bonds) widen(bond.a, bond.b);
        for (const Hinge& hinge : set.hinges) {
            widen(hinge.a, hinge.centre);
            widen(hinge.a, hinge.b);
            widen(hinge.b, hinge.centre);
        }
        for (const Dihedral& four : set.dihedrals)
            for (const auto& [a, b] : {std::pair{four.a, four.b}, std::pair{four.a, four.c}, std::pair{four.a, four.d},
                                       std::pair{four.b, four.c}, std::pair{four.b, four.d}, std::pair{four.c, four.d}})
                widen(a, b);
        for (std::size_t n = 0; n < set.size(); ++n)
            for (int axis = 0; axis < D; ++axis) {
                unknown_.push_back(set.fixed[n] ? -1 : static_cast<int>(unknowns_));
                if (!set.fixed[n]) ++unknowns_;
            }
        make_groups();
    }

    [[nodiscard]] Eigen::SparseMatrix<double> at(const Vectors& position) const {
        const Vectors rest(position.size(), Vector<double, D>{});
        const double d = 1e-6 * reach_;
        std::vector<Eigen::Triplet<double>> entries;
        for (const auto& group : groups_)
            for (int axis = 0; axis < D; ++axis) {
                Vectors plus = position, minus = position;
                for (const std::size_t n : group) {
                    plus[n][axis] += d;
                    minus[n][axis] -= d;
                }
                const Vectors ahead = body_.forces(plus, rest), behind = body_.forces(minus, rest);
                for (const std::size_t n : group)
                    for (std::size_t m = 0; m < set_.size(); ++m) {
                        if (set_.fixed[m] || (set_.position[m] - set_.position[n]).norm() > 1.001 * reach_) continue;
                        for (int k = 0; k < D; ++k)
                            entries.emplace_back(unknown_[D * m + k], unknown_[D * n + axis],
                                                 (behind[m][k] - ahead[m][k]) / (2 * d));
                    }
            }
        Eigen::SparseMatrix<double> stiffness(unknowns_, unknowns_);
        stiffness.setFromTriplets(entries.begin(), entries.end());
        return stiffness;
    }

    /// A value of the free nodes in a row, and the other way round: added to the nodes' one.
    [[nodiscard]] Eigen::VectorXd row(const Vectors& value) const {
        Eigen::VectorXd flat(unknowns_);
        for (std::size_t n = 0; n < value.size(); ++n)
            for (int axis = 0; axis < D; ++axis)
                if (unknown_[D * n + axis] >= 0) flat[unknown_[D * n + axis]] = value[n][axis];
        return flat;
    }
    void add(const Eigen::VectorXd& flat, Vectors& value) const {
        for (std::size_t n = 0; n < value.size(); ++n)
            for (int axis = 0; axis < D; ++axis)
                if (unknown_[D * n + axis] >= 0) value[n][axis] += flat[unknown_[D * n + axis]];
    }

  private:
    void make_groups() {
        for (std::size_t n = 0; n < set_.size(); ++n) {
            if (set_.fixed[n]) continue;
            const auto far = [&](const std::vector<std::size_t>& group) {
                return std::all_of(group.begin(), group.end(), [&](std::size_t m) {
                    return (set_.position[m] - set_.position[n]).norm() > 2.01 * reach_;
                });
            };
            const auto group = std::find_if(groups_.begin(), groups_.end(), far);
            if (group == groups_.end()) {
                groups_.push_back({n});
            } else {
                group->push_back(n);
            }
        }
    }

    const SpringNetwork<D>& body_;
    const ParticleSet& set_;
    double reach_ = 0;
    std::vector<int> unknown_;
    Eigen::Index unknowns_ = 0;
    std::vector<std::vector<std::size_t>> groups_;
};

/// Where the free nodes rest under small loads [N], by Newton's method. A body without fixed nodes needs loads in
/// balance; it stays where it is as a whole.
template <int D>
typename SpringNetwork<D>::Vectors statics(const SpringNetwork<D>& body, const ParticleSet& set,
                                           const typename SpringNetwork<D>::Vectors& load) {
    auto position = body.positions();
    const typename SpringNetwork<D>::Vectors rest(position.size(), Vector<double, D>{});
    const NumericalStiffness<D> stiffness(body, set);
    const auto residual = [&] {
        auto left = body.forces(position, rest);
        for (std::size_t n = 0; n < left.size(); ++n) left[n] += load[n];
        return stiffness.row(left);
    };
    const bool floats = std::count(set.fixed.begin(), set.fixed.end(), 0) == static_cast<std::ptrdiff_t>(set.size());
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
    double farthest = 0, told_apart = 0;  // what rounded places leave of forces
    for (const auto& at : position) farthest = std::max(farthest, std::sqrt(dot(at, at)));
    const auto factorise = [&] {
        Eigen::SparseMatrix<double> matrix = stiffness.at(position), small(matrix.rows(), matrix.cols());
        small.setIdentity();
        if (floats) matrix += 1e-7 * matrix.diagonal().maxCoeff() * small;
        solver.compute(matrix);
        told_apart = 1e-14 * farthest * matrix.diagonal().maxCoeff();
    };
    factorise();
    const double start = residual().norm();
    for (int iteration = 0; iteration < 15; ++iteration) {
        const Eigen::VectorXd left = residual();
        if (left.norm() < 1e-10 * start) break;
        if (iteration > 1 && left.norm() > 1e-4 * start) factorise();
        stiffness.add(solver.solve(left), position);
    }
    EXPECT_LT(residual().norm(), 1e-8 * start + told_apart);
    return position;
}

}  // namespace dmp::tests
