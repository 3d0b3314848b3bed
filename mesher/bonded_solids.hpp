// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "mesher/mesh.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// Bonds the particles of each solid with `bonds_within` where they are now, those that are so near each other and
/// whose bond stays in the drawn solid, with stiffness as bond_network.hpp says; tells the report. Throws InputError
/// where a particle has no other within reach, or was moved out of what is drawn.
void bond_solids(MeshResult& result, const Geometry& geometry, const Scene& scene);

/// Numbers bodies anew: what bonds hold together, by way of walls too, in the order of their first nodes.
void number_bodies(ParticleSet& set);

}  // namespace dmp::mesher
