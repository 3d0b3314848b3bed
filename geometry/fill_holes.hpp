// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A closed chain of open edges.
struct SurfaceHole {
    std::size_t edges = 0;
    double perimeter = 0;        ///< [m]
    Vec position = Vec::Zero();  ///< mean of its corners [m]
    std::size_t triangles = 0;   ///< that fill it; 0: it is still there
};

/// Fills the holes of a surface whose perimeter is at most a limit [m], each with the triangles of least area between
/// its corners (Barequet and Sharir, Computer Aided Geometric Design 12 (1995) 207), or around its middle if it has
/// more than 100 edges. A rim whose filling would be nearly as large as its piece of the surface belongs to a sheet and
/// stays, as do holes around which triangles face both ways. Returns all holes, by ascending number of their first
/// corner.
std::vector<SurfaceHole> fill_holes(TriangleSurface& surface, double largest_perimeter);

}  // namespace dmp::geometry
