// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/thickened_sheet.hpp"

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/orient_surface.hpp"
#include "geometry/surface_edges.hpp"

namespace dmp::geometry {

namespace {

/// By corner: the mean of its triangles' normals by their areas; zero where they cancel.
std::vector<Vec> corner_normals(const TriangleSurface& surface) {
    std::vector<Vec> normal(surface.corners.size(), Vec::Zero());
    for (const auto& triangle : surface.triangles) {
        const auto corner = [&](std::size_t k) -> const Vec& {
            return surface.corners[static_cast<std::size_t>(triangle.at(k))];
        };
        const Vec by_area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        for (const int k : triangle) normal[static_cast<std::size_t>(k)] += by_area;
    }
    for (Vec& each : normal) each.normalize();
    return normal;
}

}  // namespace

TriangleSurface thickened_sheet(TriangleSurface sheet, double thickness,
                                const std::function<bool(const Vec&, const Vec&)>& held) {
    orient_outward(sheet);
    const auto corners = static_cast<int>(sheet.corners.size());
    const std::vector<Vec> normal = corner_normals(sheet);
    TriangleSurface body;
    for (const double side : {0.5, -0.5})
        for (std::size_t k = 0; k < sheet.corners.size(); ++k)
            body.corners.emplace_back(sheet.corners[k] + side * thickness * normal[k]);
    for (const auto& [a, b, c] : sheet.triangles) {
        body.triangles.push_back({a, b, c});
        body.triangles.push_back({corners + a, corners + c, corners + b});
    }
    for_each_edge(edges_of(sheet), [&](std::span<const SurfaceEdge> sides) {
        if (sides.size() != 1) return;
        const int from = sides[0].from(), to = sides[0].to();
        const auto corner = [&](int k) -> const Vec& { return sheet.corners[static_cast<std::size_t>(k)]; };
        if (held(corner(from), corner(to))) return;
        body.triangles.push_back({to, from, corners + from});
        body.triangles.push_back({to, corners + from, corners + to});
    });
    return body;
}

}  // namespace dmp::geometry
