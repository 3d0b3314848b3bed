// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/self_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "models/contact/contact_stiffness.hpp"

namespace dmp::solver {

namespace {

constexpr double skin = 0.4;  ///< beyond the range, in ranges

}  // namespace

std::vector<std::pair<int, int>> pairs_within(const std::vector<Vec>& points, int dimension, double distance) {
    std::vector<std::pair<int, int>> pairs;
    Coordinates positions;
    for (int axis = 0; axis < dimension; ++axis)
        for (const Vec& point : points) positions[axis].push_back(point[axis]);
    const CellGrid grid(positions, points.size(), dimension, distance);
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
        grid.for_each_near({points[i][0], points[i][1], points[i][2]}, distance, [&](int j) {
            if (j > i && (points[i] - points[j]).squaredNorm() <= distance * distance) pairs.emplace_back(i, j);
        });
    std::ranges::sort(pairs);
    return pairs;
}

template <int D>
bool SelfContact<D>::moved_far(const Vectors& position) const {
    if (pruned_at_.size() != position.size()) return true;
    const double least = 0.5 * skin * contact_.range;
    for (std::size_t n = 0; n < position.size(); ++n) {
        const auto way = position[n] - pruned_at_[n];
        if (!(dot(way, way) < least * least)) return true;  // also true for NaN
    }
    return false;
}

template <int D>
void SelfContact<D>::search_around(const Vectors& position) {
    pairs_.clear();
    pruned_at_ = position;
    Coordinates points;
    for (int axis = 0; axis < D; ++axis)
        for (const auto& at : position) {
            // A position that is not finite belongs to no cell; the next step reports it.
            if (!std::isfinite(at[axis])) return;
            points[axis].push_back(at[axis]);
        }
    const double reach = (1 + skin) * contact_.range;
    const CellGrid grid(points, position.size(), D, reach);
    for (int i = 0; i < static_cast<int>(position.size()); ++i) {
        std::array<double, 3> here{};
        for (int axis = 0; axis < D; ++axis) here[axis] = position[i][axis];
        grid.for_each_near(here, reach, [&](int j) {
            if (j <= i) return;
            if (!left_out_.empty() && (left_out_[i] != 0 || left_out_[j] != 0)) return;
            const auto apart = position[i] - position[j];
            if (dot(apart, apart) < reach * reach && !std::ranges::binary_search(held_apart_, std::pair(i, j)))
                pairs_.emplace_back(i, j);
        });
    }
    std::sort(pairs_.begin(), pairs_.end());
}

template <int D>
void SelfContact<D>::add_forces(const Vectors& position, Vectors& force) {
    if (moved_far(position)) search_around(position);
    for (const auto& [i, j] : pairs_) {
        const auto apart = position[i] - position[j];
        if (!(dot(apart, apart) < contact_.range * contact_.range)) continue;
        const auto by_other = contact_.repulsion.law(apart, contact_.range);
        force[i] += by_other;
        force[j] -= by_other;
    }
}

template <int D>
double SelfContact<D>::rate(const Vectors& position, const std::vector<double>& inverse_mass) {
    if (moved_far(position)) search_around(position);
    std::vector<double> sum(pairs_.empty() ? 0 : position.size(), 0);
    for (const auto& [i, j] : pairs_) {
        const auto apart = position[i] - position[j];
        const double stiffness = contact_stiffness(contact_.repulsion, dot(apart, apart), contact_.range);
        sum[i] += contact_rate(stiffness, inverse_mass[i], inverse_mass[j]);
        sum[j] += contact_rate(stiffness, inverse_mass[j], inverse_mass[i]);
    }
    return sum.empty() ? 0 : *std::ranges::max_element(sum);
}

template class SelfContact<2>;
template class SelfContact<3>;

}  // namespace dmp::solver
