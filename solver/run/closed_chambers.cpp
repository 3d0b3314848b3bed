// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/closed_chambers.hpp"

#include <algorithm>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "particles/cell_grid.hpp"
#include "solver/neighbours/chambers.hpp"

namespace dmp::solver {

namespace {

/// Number of chambers of liquid as it starts.
std::int64_t chambers_at_start(const ParticleSet& set) {
    const double reach = ChamberLinks::reach(set.spacing);
    Coordinates points;
    std::vector<std::size_t> source;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        for (int axis = 0; axis < set.dimension; ++axis)
            points[axis].push_back(set.periodic[axis]
                                       ? wrapped(set.position[i][axis], set.box.low[axis], set.box.high[axis])
                                       : set.position[i][axis]);
        source.push_back(source.size());
    }
    const std::size_t count = source.size();
    for (int axis = set.dimension; axis < 3; ++axis) points[axis].assign(count, 0);
    for (const PeriodicImage& image : periodic_images(points, count, set.box, set.periodic, reach)) {
        for (int axis = 0; axis < 3; ++axis) points[axis].push_back(points[axis][image.source] + image.shift[axis]);
        source.push_back(static_cast<std::size_t>(image.source));
    }
    const CellGrid grid(points, source.size(), set.dimension, reach);
    DisjointSets sets(count);
    for (std::size_t i = 0; i < count; ++i)
        grid.for_each_near({points[0][i], points[1][i], points[2][i]}, reach, [&](int j) {
            double square = 0;
            for (int axis = 0; axis < set.dimension; ++axis) {
                const double apart = points[axis][j] - points[axis][i];
                square += apart * apart;
            }
            if (square < reach * reach) sets.join(i, source[static_cast<std::size_t>(j)]);
        });
    std::vector<std::int64_t> particles(count);
    for (std::size_t i = 0; i < count; ++i) ++particles[sets.find(i)];
    const std::int64_t fewest = ChamberLinks::fewest_particles(set.dimension);
    return std::ranges::count_if(particles, [&](std::int64_t of_root) { return of_root >= fewest; });
}

}  // namespace

bool may_have_chambers(const Scene& scene, const ParticleSet& set) {
    if (scene.changes_bodies()) return true;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::elastic && !set.fixed[i]) return true;
    return chambers_at_start(set) > 1;
}

}  // namespace dmp::solver
