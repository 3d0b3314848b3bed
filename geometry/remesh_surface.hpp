// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A connected surface in nearly equilateral triangles with edges of about `edge` [m], whose corners lie on the given
/// triangles: gmsh's frontal Delaunay mesh (Remacle et al., International Journal for Numerical Methods in Engineering
/// 94 (2013) 494) of a map of the surface to the plane. Borders stay where they are, with corners evenly along them;
/// their own corners, where they turn by more than 30 degrees, stay. Closed surfaces are cut into pieces for it, whose
/// seams have shorter edges. All triangles are then oriented alike. Safe to call
/// from several threads, one at a time. Throws InputError where more than two triangles share an edge, the surface has
/// only one side, or gmsh finds no map of it; std::invalid_argument for an edge that is not positive.
TriangleSurface remesh_surface(const TriangleSurface& surface, double edge);

}  // namespace dmp::geometry
