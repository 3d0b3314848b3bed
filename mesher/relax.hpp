// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// In 3-D a layer sinks into the gaps of the next, and fluid so far into those of a body that contact would throw it
/// out: fluid keeps this distance from a body's nodes [spacings].
constexpr double keep_from_nodes = 0.9;
/// Where liquid fills what solids of cells leave of a box: from their particles [spacings].
constexpr double keep_from_cells = 0.7;

/// Moves fluid particles near spring bodies until they are evenly spread: where a slanted body cuts the lattice,
/// particles stand too near or leave gaps. Steepest descent on the same sum that particle shifting uses; other
/// particles stay on the lattice. `support` is the kernel's support radius [m]; `may_stand(i, point)` says whether
/// particle i may stand at a point of the box: it never leaves the places where it may.
void relax_around_bodies(ParticleSet& set, double support,
                         const std::function<bool(std::size_t, const Vec&)>& may_stand);

/// Marks spring nodes drawn so near a wall that contact would push from the start: nearer than `contact_range` [m].
void mark_seated(ParticleSet& set, double contact_range);

}  // namespace dmp::mesher
