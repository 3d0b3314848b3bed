// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/triangle_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dmp::solver {

namespace {

constexpr double most_cells_an_axis = 64;

}  // namespace

TriangleGrid::TriangleGrid(const std::vector<std::array<Vec, 3>>& triangles, double reach) {
    Vec high = Vec::Constant(-std::numeric_limits<double>::infinity());
    low_ = -high;
    for (const auto& corners : triangles)
        for (const Vec& corner : corners) {
            low_ = low_.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    low_ -= Vec::Constant(reach);
    high += Vec::Constant(reach);
    const double cell = std::max(2 * reach, (high - low_).maxCoeff() / most_cells_an_axis);
    inverse_cell_ = 1 / cell;
    for (int axis = 0; axis < 3; ++axis)
        cells_[static_cast<std::size_t>(axis)] =
            static_cast<std::int64_t>(std::floor((high[axis] - low_[axis]) * inverse_cell_)) + 1;
    start_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2]) + 1, 0);

    const auto for_each_cell = [&](const std::array<Vec, 3>& corners, const auto& visit) {
        const Vec from = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - Vec::Constant(reach) - low_;
        const Vec to = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]) + Vec::Constant(reach) - low_;
        std::array<std::int64_t, 3> first{}, last{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const auto cell_at = [&](double x) {
                return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(x * inverse_cell_)), 0,
                                                cells_[a] - 1);
            };
            first[a] = cell_at(from[axis]);
            last[a] = cell_at(to[axis]);
        }
        for (std::int64_t z = first[2]; z <= last[2]; ++z)
            for (std::int64_t y = first[1]; y <= last[1]; ++y)
                for (std::int64_t x = first[0]; x <= last[0]; ++x)
                    visit(static_cast<std::size_t>((z * cells_[1] + y) * cells_[0] + x));
    };
    for (const auto& corners : triangles) for_each_cell(corners, [&](std::size_t k) { ++start_[k + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    number_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<std::int32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for_each_cell(triangles[t], [&](std::size_t k) {
            number_[static_cast<std::size_t>(next[k]++)] = static_cast<std::int32_t>(t);
        });
}

std::vector<Vec> shifts_near(const ParticleSpace& space, const Vec& point, double reach) {
    std::vector<Vec> shifts{Vec::Zero()};
    for (int axis = 0; axis < 3; ++axis) {
        if (!space.periodic[static_cast<std::size_t>(axis)]) continue;
        const double period = space.box.high[axis] - space.box.low[axis];
        const std::size_t count = shifts.size();
        const auto add = [&](double shift) {
            for (std::size_t k = 0; k < count; ++k) {
                Vec other = shifts[k];
                other[axis] = shift;
                shifts.push_back(other);
            }
        };
        // What lies near the low side comes to a sphere at the high side a period farther on.
        if (point[axis] > space.box.high[axis] - reach) add(period);
        if (point[axis] < space.box.low[axis] + reach) add(-period);
    }
    return shifts;
}

}  // namespace dmp::solver
