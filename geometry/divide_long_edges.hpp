// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// The same surface with no edge longer than `longest` [m]: longer ones are halved until none is left, in all the
/// triangles that share them, so that these still share their corners. Any triangles will do. Those that are divided
/// stand after one another in the place of the one they come from. Throws std::invalid_argument for a length that is
/// not positive.
TriangleSurface divide_long_edges(TriangleSurface surface, double longest);

}  // namespace dmp::geometry
