// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/wrap_surface.hpp"

#include <array>
#include <stdexcept>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

namespace dmp::geometry {

TriangleSurface wrap_surface(const TriangleSurface& surface, double alpha, double offset) {
    if (!(alpha > 0) || !(offset > 0)) throw std::invalid_argument("wrap_surface: alpha and offset must be positive");
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    std::vector<Point> points;
    points.reserve(surface.corners.size());
    for (const Vec& corner : surface.corners) points.emplace_back(corner.x(), corner.y(), corner.z());
    std::vector<std::array<std::size_t, 3>> faces;
    faces.reserve(surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles)
        faces.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
    CGAL::Surface_mesh<Point> wrap;
    CGAL::alpha_wrap_3(points, faces, alpha, offset, wrap);

    TriangleSurface wrapped;
    std::vector<int> number(wrap.number_of_vertices() + wrap.number_of_removed_vertices(), -1);
    for (const auto vertex : wrap.vertices()) {
        number[vertex] = static_cast<int>(wrapped.corners.size());
        const Point& point = wrap.point(vertex);
        wrapped.corners.emplace_back(point.x(), point.y(), point.z());
    }
    for (const auto face : wrap.faces()) {
        std::array<int, 3>& triangle = wrapped.triangles.emplace_back();
        std::size_t k = 0;
        for (const auto vertex : wrap.vertices_around_face(wrap.halfedge(face))) triangle.at(k++) = number[vertex];
    }
    return wrapped;
}

}  // namespace dmp::geometry
