// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/implicit_system.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

template <int D>
SpringNetwork<D>::ImplicitSystem::ImplicitSystem(const SpringNetwork& body) {
    int unknowns = 0;
    for (std::size_t node = 0; node < body.ids_.size(); ++node)
        for (int axis = 0; axis < D; ++axis) unknown_.push_back(body.is_held(node, axis) ? -1 : unknowns++);
    std::vector<Eigen::Triplet<double>> pattern;
    const auto couple = [&](int a, int b) {
        for (int i = 0; i < D; ++i)
            for (int j = 0; j < D; ++j) {
                const int row = unknown(a, i), column = unknown(b, j);
                if (row < 0 || column < 0) continue;
                pattern.emplace_back(std::max(row, column), std::min(row, column), 0.0);
            }
    };
    for (int node = 0; node < static_cast<int>(nodes()); ++node) couple(node, node);
    const auto couple_all = [&](const auto& each) {
        for (std::size_t a = 0; a < each.node.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) couple(each.node[a], each.node[b]);
    };
    body.for_each_spring(couple_all);
    for (const LocalCell<D>& cell : body.cells_) couple_all(cell);
    matrix_.resize(unknowns, unknowns);
    matrix_.setFromTriplets(pattern.begin(), pattern.end());
    matrix_.makeCompressed();
    solver_.analyzePattern(matrix_);
}

template <int D>
double& SpringNetwork<D>::ImplicitSystem::entry(int row, int column) {
    const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return matrix_.valuePtr()[std::lower_bound(begin, end, row) - matrix_.innerIndexPtr()];
}

template <int D>
template <class Law, class Slope>
void SpringNetwork<D>::ImplicitSystem::add(const LocalSpring<D, Law>& spring, const Slope& slope, double weight) {
    constexpr int nodes = Law::nodes;
    std::array<Vector<double, D>, nodes> gradient{};
    for (std::size_t k = 0; k < slope.size(); ++k) {
        gradient[Law::arms[k].end] += slope[k];
        gradient[Law::arms[k].start] -= slope[k];
    }
    for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j)
                    add(unknown(spring.node[a], i), unknown(spring.node[b], j),
                        weight * gradient[a][i] * gradient[b][j]);
}

template <int D>
void SpringNetwork<D>::ImplicitSystem::add(const LocalCell<D>& cell,
                                           const typename LocalCell<D>::Element::Square& stiffness) {
    constexpr int corners = LocalCell<D>::Element::corners;
    for (int a = 0; a < corners; ++a)
        for (int b = 0; b < corners; ++b)
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j)
                    add(unknown(cell.node[a], i), unknown(cell.node[b], j), stiffness(a * D + i, b * D + j));
}

template <int D>
void SpringNetwork<D>::ImplicitSystem::factorise(const SpringNetwork& body, const Vectors& position, double dt,
                                                 std::span<const Vec> more) {
    dt_ = dt;
    position_ = position;
    std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
    for_each_unknown([&](std::size_t node, int, int number) {
        entry(number, number) += body.mass_[node] + dt / 2 * body.drag_[node];
    });
    body.for_each_spring([&](const auto& spring) {
        const auto arms = spring.arms_at(position);
        add(spring, spring.law.deviation(arms).gradient,
            dt / 2 * spring.law.dashpot + dt * dt / 4 * 2 * spring.law.stiffness);
        spring.law.extra_stiffness(arms,
                                   [&](double weight, const auto& slope) { add(spring, slope, dt * dt / 4 * weight); });
    });
    for (const LocalCell<D>& cell : body.cells_)
        add(cell, cell.stiffness(cell.at(position), dt * dt / 4, dt / 2 * cell.relaxation));
    more_.setZero(matrix_.rows());
    if (more.empty()) {
        solver_.factorize(matrix_);
    } else {
        for_each_unknown([&](std::size_t node, int axis, int number) { more_[number] = more[node][axis]; });
        Matrix sum = matrix_;
        sum.diagonal() += more_;
        solver_.factorize(sum);
    }
    if (solver_.info() != Eigen::Success)
        throw DivergenceError("the stiffness of an elastic body is no longer finite",
                              "lower numerics.step_factor or check the drive");
}

template <int D>
void SpringNetwork<D>::ImplicitSystem::archive(Archive& file, const std::string& name, const SpringNetwork& body) {
    double dt = dt_;
    Vectors position = position_;
    file(name + "/factors_dt", dt);
    file(name + "/factors_position", position);
    if (!file.loading()) return;
    if (!std::isfinite(dt) || (dt > 0 && position.size() != nodes()))
        throw unlike_any_run("factors of an elastic body that fit none");
    if (dt > 0) factorise(body, position, dt);
}

template <int D>
template <class Map>
void SpringNetwork<D>::ImplicitSystem::change(std::span<Vec> values, double scale, const Map& map) const {
    Eigen::VectorXd free(matrix_.rows());
    for_each_unknown([&](std::size_t node, int axis, int number) { free[number] = values[node][axis]; });
    const Eigen::VectorXd image = map(free);
    for (std::size_t node = 0; node < nodes(); ++node)
        for (int i = 0; i < D; ++i) values[node][i] = unknown(node, i) >= 0 ? scale * image[unknown(node, i)] : 0;
}

template <int D>
void SpringNetwork<D>::ImplicitSystem::multiply(std::span<Vec> values, double scale) const {
    change(values, scale, [this](const Eigen::VectorXd& free) -> Eigen::VectorXd {
        return matrix_.template selfadjointView<Eigen::Lower>() * free;
    });
}

template <int D>
void SpringNetwork<D>::ImplicitSystem::solve(std::span<Vec> values, double scale) const {
    change(values, scale, [this](const Eigen::VectorXd& free) -> Eigen::VectorXd { return solver_.solve(free); });
}

template <int D>
void SpringNetwork<D>::ImplicitSystem::add_factorised(int first, double scale,
                                                      std::vector<Eigen::Triplet<double>>& entries) const {
    std::vector<int> row(static_cast<std::size_t>(matrix_.rows()));
    for_each_unknown([&](std::size_t node, int axis, int number) {
        row[static_cast<std::size_t>(number)] = first + static_cast<int>(node) * D + axis;
        entries.emplace_back(row[static_cast<std::size_t>(number)], row[static_cast<std::size_t>(number)],
                             scale * more_[number]);
    });
    for (int column = 0; column < matrix_.outerSize(); ++column)
        for (Matrix::InnerIterator entry(matrix_, column); entry; ++entry)
            entries.emplace_back(row[static_cast<std::size_t>(entry.row())], row[static_cast<std::size_t>(column)],
                                 scale * entry.value());
}

template <int D>
double SpringNetwork<D>::ImplicitSystem::correct(const Vectors& residual, double dt, Vectors& position,
                                                 Vectors& velocity) {
    Eigen::VectorXd right(matrix_.rows());
    for_each_unknown([&](std::size_t node, int axis, int number) { right[number] = residual[node][axis]; });
    const Eigen::VectorXd change = solver_.solve(right);
    double largest = 0;
    for_each_unknown([&](std::size_t node, int axis, int number) {
        const double dv = change[number];
        velocity[node][axis] += dv;
        position[node][axis] += dt / 2 * dv;
        // Not std::max, which would lose a NaN.
        if (!(std::abs(dv) * dt / 2 <= largest)) largest = std::abs(dv) * dt / 2;
    });
    return largest;
}

template class SpringNetwork<2>::ImplicitSystem;
template class SpringNetwork<3>::ImplicitSystem;

}  // namespace dmp::solver
