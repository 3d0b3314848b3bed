// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/set_grid.hpp"

#include <cmath>
#include <numeric>
#include <string>

#include "base/errors.hpp"
#include "base/length_text.hpp"

namespace dmp::particles {

namespace {

/// Positions in the box along periodic axes, the unused axis left at 0.
Coordinates coordinates(const ParticleSet& set) {
    Coordinates points;
    for (auto& axis : points) axis.assign(set.size(), 0);
    for (std::size_t i = 0; i < set.size(); ++i)
        for (int axis = 0; axis < set.dimension; ++axis) {
            const double x = set.position[i][axis];
            if (!std::isfinite(x))
                throw InputError("particle " + std::to_string(i) + " of '" +
                                     set.parts[static_cast<std::size_t>(set.part[i])].name +
                                     "' is at no place: " + position_text(set.position[i], set.dimension),
                                 "Mesh the scene again.");
            points[axis][i] = set.periodic[axis] ? wrapped(x, set.box.low[axis], set.box.high[axis]) : x;
        }
    return points;
}

}  // namespace

SetGrid::SetGrid(const ParticleSet& set, double reach) : reach_(reach), points_(coordinates(set)), id_(set.size()) {
    std::iota(id_.begin(), id_.end(), 0);
    for (const PeriodicImage& image : periodic_images(points_, set.size(), set.box, set.periodic, reach)) {
        for (int axis = 0; axis < 3; ++axis) points_[axis].push_back(points_[axis][image.source] + image.shift[axis]);
        id_.push_back(image.source);
    }
    grid_ = CellGrid(points_, id_.size(), set.dimension, std::max(reach, set.spacing));
}

}  // namespace dmp::particles
