// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "base/vec.hpp"
#include "geometry/triangle_surface.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// Whether all points lie on one periodic side or plane of symmetry of the box, beyond which a solid goes on.
bool on_open_side(std::span<const Vec> points, const ParticleSpace& space);

/// The surface without the triangles that lie on one.
TriangleSurface without_open_sides(TriangleSurface surface, const ParticleSpace& space);

}  // namespace dmp::mesher
