// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/mesh.hpp"

namespace dmp::mesher {

/// Makes the bonds that the scene's [[join]] ask for, where the particles are now, and one body of what they join; says
/// so in the report. No bond is made between two particles that are held, a second one between the same two, nor one
/// across a gap: where a particle of another part is nearer to its middle than 0.8 of its half (after Gabriel & Sokal
/// 1969). Throws InputError for a join that finds nothing within its reach.
void join_parts(MeshResult& result, const Scene& scene);

}  // namespace dmp::mesher
