// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// Divides triangles at T-junctions: where a corner of an open edge lies on another open edge, to within a distance
/// [m], between its ends. The two sides then share their corners. Returns how many corners were put on edges.
std::size_t split_at_t_junctions(TriangleSurface& surface, double distance);

}  // namespace dmp::geometry
