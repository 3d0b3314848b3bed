// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/even_triangles.hpp"

#include "geometry/divide_long_edges.hpp"

namespace dmp::geometry {

TriangleSurface even_triangles(const TriangleSurface& surface, double edge) {
    return divide_long_edges(surface, 4.0 / 3 * edge);
}

}  // namespace dmp::geometry
