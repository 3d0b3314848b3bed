// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/self_contact.hpp"

#include <algorithm>
#include <cmath>

namespace dmp {

template <int D>
void SelfContact<D>::add_forces(const Vectors& position, Vectors& force) const {
    const std::size_t nodes = position.size();
    Coordinates points;
    for (int axis = 0; axis < D; ++axis)
        for (const auto& at : position) points[axis].push_back(at[axis]);
    // A place that is no number belongs to no cell; the step that follows says so.
    for (const auto& axis : points)
        if (!std::all_of(axis.begin(), axis.end(), [](double x) { return std::isfinite(x); })) return;

    const CellGrid grid(points, nodes, D, contact_.range);
    const double range_square = contact_.range * contact_.range;
    std::vector<int> partners;
    for (std::size_t i = 0; i < nodes; ++i) {
        std::array<double, 3> here{};
        for (int axis = 0; axis < D; ++axis) here[axis] = position[i][axis];
        partners.clear();
        grid.for_each_near(here, contact_.range, [&](int j) {
            const auto apart = position[i] - position[j], drawn_apart = drawn_[i] - drawn_[j];
            if (dot(apart, apart) < range_square && dot(drawn_apart, drawn_apart) > neighbourhood_square_)
                partners.push_back(j);
        });
        std::sort(partners.begin(), partners.end());
        for (const int j : partners) force[i] += contact_.repulsion.law(position[i] - position[j], contact_.range);
    }
}

template class SelfContact<2>;
template class SelfContact<3>;

}  // namespace dmp
