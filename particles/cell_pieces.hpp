// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/disjoint_sets.hpp"
#include "particles/particle_set.hpp"

namespace dmp::particles {

/// Puts the particles of cells that share a node together: they hang together as particles that are bonded do.
inline void join_cells(const ParticleSet& set, DisjointSets& together) {
    std::vector<int> first(set.cell_nodes.size(), -1);  // by node: the first cell's particle
    for (const SolidCell& cell : set.cells)
        for (int k = 0; k < 1 << set.dimension; ++k) {
            int& there = first[static_cast<std::size_t>(cell.node[static_cast<std::size_t>(k)])];
            if (there < 0) there = cell.particle;
            together.join(static_cast<std::size_t>(there), static_cast<std::size_t>(cell.particle));
        }
}

}  // namespace dmp::particles
