// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// The surface in triangles with edges of about `edge` [m], 4/3 of it at most.
TriangleSurface even_triangles(const TriangleSurface& surface, double edge);

}  // namespace dmp::geometry
