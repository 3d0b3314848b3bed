// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The largest pressure that body forces cause in each fluid, by part of the set [Pa]; 0 for solids. The acceleration
/// and the mean pressure gradient are the largest of 64 instants of the run (components that depend on place count 0);
/// pressures of several axes are added up.
/// - Along an axis that is not periodic: the weight of the fluid above, at the start. A layer of one spacing is as
/// dense
///   as the densest fluid in it.
/// - Along a periodic axis with solids in the way of the flow: that of the densest fluid over the whole period. Where
///   all solids run straight along the axis, the force drives the fluid and no pressure holds it.
std::vector<double> column_pressures(const Scene& scene, const ParticleSet& set);

}  // namespace dmp::solver
