// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/apart.hpp"

#include <cmath>
#include <sstream>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::particles {

namespace {

std::string called(const ParticleSet& set, std::size_t i) {
    return std::to_string(i) + " of '" + set.parts[static_cast<std::size_t>(set.part[i])].name + "'";
}

std::string position(const ParticleSet& set, std::size_t i) { return position_text(set.position[i], set.dimension); }

/// Positions in the box along periodic axes, the unused axis left at 0.
Coordinates coordinates(const ParticleSet& set) {
    Coordinates points;
    for (auto& axis : points) axis.assign(set.size(), 0);
    for (std::size_t i = 0; i < set.size(); ++i)
        for (int axis = 0; axis < set.dimension; ++axis) {
            const double x = set.position[i][axis];
            if (!std::isfinite(x))
                throw InputError("particle " + called(set, i) + " is at no place: " + position(set, i),
                                 "Mesh the scene again.");
            points[axis][i] = set.periodic[axis] ? wrapped(x, set.box.low[axis], set.box.high[axis]) : x;
        }
    return points;
}

}  // namespace

void check_apart(const ParticleSet& set) {
    Coordinates points = coordinates(set);
    const double reach = nearest_apart * set.spacing;
    std::vector<int> id(set.size());
    for (std::size_t i = 0; i < set.size(); ++i) id[i] = static_cast<int>(i);
    for (const PeriodicImage& image : periodic_images(points, set.size(), set.box, set.periodic, reach)) {
        for (int axis = 0; axis < 3; ++axis) points[axis].push_back(points[axis][image.source] + image.shift[axis]);
        id.push_back(image.source);
    }
    const CellGrid grid(points, id.size(), set.dimension, set.spacing);
    for (std::size_t i = 0; i < set.size(); ++i) {
        const std::array<double, 3> centre{points[0][i], points[1][i], points[2][i]};
        grid.for_each_near(centre, reach, [&](int k) {
            if (id[k] == static_cast<int>(i)) return;
            double square = 0;
            for (int axis = 0; axis < set.dimension; ++axis)
                square += (points[axis][k] - centre[axis]) * (points[axis][k] - centre[axis]);
            if (square < reach * reach)
                throw InputError("particles " + called(set, i) + " and " +
                                     called(set, static_cast<std::size_t>(id[k])) + " lie on each other at " +
                                     position(set, i),
                                 "Check the geometry for parts that overlap or lines drawn twice near there, or choose "
                                 "another particles.spacing.");
        });
    }
}

}  // namespace dmp::particles
