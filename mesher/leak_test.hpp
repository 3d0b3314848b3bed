// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/mesh.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// Whether walls hold the fluid in: floods the space around the particles, in cells of half a spacing, from cell to
/// cell through their sides. The flood starts at the outer sides of the box, a spacing off the outermost particles, and
/// in rooms inside walls (empty within a spacing and a half all round); periodic sides and planes of symmetry are
/// capped. A wall particle fills the cells whose centres lie within 0.6 spacings of it along each axis: gaps of up to
/// 0.2 spacings between their cubes are closed, and of one missing particle 0.8 spacings stay open. A fluid particle
/// (0.5 spacings) that the flood reaches is a leak. Takes a byte a cell: 8 cells a particle's volume, over the whole
/// box.
MeshReport::LeakLine find_leaks(const ParticleSet& set);

}  // namespace dmp::mesher
