// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_surface.hpp"

#include <Eigen/Geometry>

namespace dmp::geometry {

double TriangleSurface::area() const {
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const Vec& corner = corners[static_cast<std::size_t>(a)];
        sum +=
            0.5 *
            (corners[static_cast<std::size_t>(b)] - corner).cross(corners[static_cast<std::size_t>(c)] - corner).norm();
    }
    return sum;
}

double TriangleSurface::enclosed_volume() const {
    double sum = 0;
    if (corners.empty()) return sum;
    const Vec& origin = corners.front();  // near the surface: little is lost where the geometry is far from zero
    for (const auto& [a, b, c] : triangles)
        sum += (corners[static_cast<std::size_t>(a)] - origin)
                   .dot((corners[static_cast<std::size_t>(b)] - origin)
                            .cross(corners[static_cast<std::size_t>(c)] - origin)) /
               6;
    return sum;
}

}  // namespace dmp::geometry
