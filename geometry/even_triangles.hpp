// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// The surface in nearly equilateral triangles with edges of about `edge` [m], 4/3 of it at most but for rounding,
/// whose corners lie on the given triangles and which face as these do: edges are split, collapsed and flipped, and
/// corners moved along the surface, by CGAL (Botsch and Kobbelt, Symposium on Geometry Processing 2004, 185). Borders
/// and edges where the surface turns by more than 30 degrees stay where they are, and so do their own corners. Round
/// features smaller than `edge` get smaller triangles. Any triangles will do: where more than two share an edge, or two
/// that face different sides, their corners become several in one place, and pieces that cannot be remeshed have their
/// long edges halved (divide_long_edges). Throws std::invalid_argument for an edge that is not positive.
TriangleSurface even_triangles(const TriangleSurface& surface, double edge);

}  // namespace dmp::geometry
