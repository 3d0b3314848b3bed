// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/mesh.hpp"

namespace dmp::mesher {

/// Bonds of each node of a particle set.
std::vector<int> valence(const ParticleSet& set);

/// Adds to the report's spring parts how many nodes have how many bonds, and how many pieces their own bonds make of
/// them.
void count_bonds(MeshResult& result);

}  // namespace dmp::mesher
