// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A closed surface without self-intersections around any triangles (Portaneri, Rouxel-Labbe, Hemmer, Cohen-Steiner and
/// Alliez, ACM Transactions on Graphics 41 (2022) 127; CGAL's alpha_wrap_3). It keeps out of holes narrower than about
/// `alpha` [m] and lies at a distance `offset` [m] outside of the triangles; walls inside are lost. Time and memory
/// grow with the surface's area over alpha squared. Throws std::invalid_argument for lengths that are not positive.
TriangleSurface wrap_surface(const TriangleSurface& surface, double alpha, double offset);

}  // namespace dmp::geometry
