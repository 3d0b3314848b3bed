// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Mass by particle [kg]: of the nodes of strips and shells with the liquid in them. Two layers of nodes are two
/// spacings thick, a thin leaflet is not: what is in the difference is liquid of `liquid_density` [kg/m^3; 0: none],
/// which moves with the leaflet. So a node weighs in the liquid what its material does, and is never much lighter than
/// the liquid it displaces, which would need short steps (docs/elastic.md). A strip is taken to be as thick as its
/// rows of nodes, and one lighter than the liquid that it displaces to have the liquid's density; beyond its ends,
/// where its last columns stand for half a cell, is liquid. Solids of cells fill
/// their volume; where the nodes of one of springs are fewer than what is drawn, they have as much less of the liquid.
std::vector<double> node_masses(const Scene& scene, const ParticleSet& set, double liquid_density);

/// Density of that liquid [kg/m^3], of several fluids the densest; 0: solids are not wet all around, or the scheme is
/// the plain one, which takes masses as given, as the published studies do.
inline double liquid_in_leaflets(const PairSettings& settings) {
    return settings.subtracts_level && !settings.dry_bodies ? settings.density.largest : 0;
}

}  // namespace dmp::solver
