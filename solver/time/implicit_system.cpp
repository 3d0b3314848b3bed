// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/implicit_system.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace dmp {

SpringBody::ImplicitSystem::ImplicitSystem(const SpringBody& body) {
    int unknowns = 0;
    for (const auto fixed : body.fixed_) {
        unknown_.push_back(fixed ? -1 : unknowns);
        if (!fixed) unknowns += 2;
    }
    std::vector<Eigen::Triplet<double>> pattern;
    const auto couple = [&](int a, int b) {
        if (unknown_[a] < 0 || unknown_[b] < 0) return;
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) {
                const int row = unknown_[a] + i, column = unknown_[b] + j;
                pattern.emplace_back(std::max(row, column), std::min(row, column), 0.0);
            }
    };
    for (int node = 0; node < static_cast<int>(unknown_.size()); ++node) couple(node, node);
    for (const LocalBond& bond : body.bonds_) couple(bond.a, bond.b);
    for (const LocalHinge& hinge : body.hinges_) {
        couple(hinge.a, hinge.b);
        couple(hinge.a, hinge.centre);
        couple(hinge.b, hinge.centre);
    }
    matrix_.resize(unknowns, unknowns);
    matrix_.setFromTriplets(pattern.begin(), pattern.end());
    matrix_.makeCompressed();
    solver_.analyzePattern(matrix_);
}

double& SpringBody::ImplicitSystem::entry(int row, int column) {
    const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return matrix_.valuePtr()[std::lower_bound(begin, end, row) - matrix_.innerIndexPtr()];
}

void SpringBody::ImplicitSystem::add(const std::array<int, 3>& nodes, int count, const Gradient& gradient,
                                     double weight) {
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) {
            const int row = unknown_[nodes[a]], column = unknown_[nodes[b]];
            if (row < 0 || column < 0) continue;
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j)
                    if (row + i >= column + j) entry(row + i, column + j) += weight * gradient[a][i] * gradient[b][j];
        }
}

void SpringBody::ImplicitSystem::factorise(const SpringBody& body, const Vectors& position, double dt,
                                           std::span<const Vector<double, 2>> more) {
    dt_ = dt;
    position_ = position;
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
    for (std::size_t node = 0; node < unknown_.size(); ++node)
        for (int i = 0; i < 2 && unknown_[node] >= 0; ++i)
            entry(unknown_[node] + i, unknown_[node] + i) += body.mass_[node] + dt / 2 * body.drag_;
    for (const LocalBond& bond : body.bonds_) {
        const auto separation = position[bond.a] - position[bond.b];
        const auto direction = (1 / std::sqrt(dot(separation, separation))) * separation;
        add({bond.a, bond.b, 0}, 2, {direction, -1.0 * direction},
            dt / 2 * bond.force.dashpot + dt * dt / 4 * 2 * bond.force.stiffness);
    }
    for (const LocalHinge& hinge : body.hinges_) {
        const auto turning = [&](int end) {
            const auto arm = position[end] - position[hinge.centre];
            return (1 / dot(arm, arm)) * Vector<double, 2>{{-arm[1], arm[0]}};
        };
        const auto by_b = turning(hinge.b), by_a = -1.0 * turning(hinge.a);
        add({hinge.a, hinge.centre, hinge.b}, 3, {by_a, -1.0 * (by_a + by_b), by_b},
            dt / 2 * hinge.force.dashpot + dt * dt / 4 * 2 * hinge.force.stiffness);
    }
    if (more.empty()) {
        solver_.factorize(matrix_);
    } else {
        Matrix sum = matrix_;
        for (std::size_t node = 0; node < unknown_.size(); ++node)
            for (int i = 0; i < 2 && unknown_[node] >= 0; ++i)
                sum.coeffRef(unknown_[node] + i, unknown_[node] + i) += more[node][i];
        solver_.factorize(sum);
    }
    if (solver_.info() != Eigen::Success)
        throw DivergenceError("the stiffness of a spring body is no longer finite",
                              "lower accuracy.step_factor or check the drive");
}

void SpringBody::ImplicitSystem::archive(Archive& file, const std::string& name, const SpringBody& body) {
    double dt = dt_;
    Vectors position = position_;
    file(name + "/factors_dt", dt);
    file(name + "/factors_position", position);
    if (file.loading() && dt > 0) factorise(body, position, dt);
}

template <class Map>
void SpringBody::ImplicitSystem::change(std::span<Vector<double, 2>> values, double scale, const Map& map) const {
    Eigen::VectorXd free(matrix_.rows());
    for (std::size_t node = 0; node < unknown_.size(); ++node)
        for (int i = 0; i < 2 && unknown_[node] >= 0; ++i) free[unknown_[node] + i] = values[node][i];
    const Eigen::VectorXd image = map(free);
    for (std::size_t node = 0; node < unknown_.size(); ++node)
        for (int i = 0; i < 2; ++i) values[node][i] = unknown_[node] >= 0 ? scale * image[unknown_[node] + i] : 0;
}

void SpringBody::ImplicitSystem::multiply(std::span<Vector<double, 2>> values, double scale) const {
    change(values, scale, [this](const Eigen::VectorXd& free) -> Eigen::VectorXd {
        return matrix_.selfadjointView<Eigen::Lower>() * free;
    });
}

void SpringBody::ImplicitSystem::solve(std::span<Vector<double, 2>> values, double scale) const {
    change(values, scale, [this](const Eigen::VectorXd& free) -> Eigen::VectorXd { return solver_.solve(free); });
}

double SpringBody::ImplicitSystem::correct(const Vectors& residual, double dt, Vectors& position, Vectors& velocity) {
    Eigen::VectorXd right(matrix_.rows());
    for (std::size_t node = 0; node < unknown_.size(); ++node)
        for (int i = 0; i < 2 && unknown_[node] >= 0; ++i) right[unknown_[node] + i] = residual[node][i];
    const Eigen::VectorXd change = solver_.solve(right);
    double largest = 0;
    for (std::size_t node = 0; node < unknown_.size(); ++node)
        for (int i = 0; i < 2 && unknown_[node] >= 0; ++i) {
            const double dv = change[unknown_[node] + i];
            velocity[node][i] += dv;
            position[node][i] += dt / 2 * dv;
            // Not std::max: a number that is none has to come out.
            if (!(std::abs(dv) * dt / 2 <= largest)) largest = std::abs(dv) * dt / 2;
        }
    return largest;
}

}  // namespace dmp
