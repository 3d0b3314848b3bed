// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_intersections.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include "geometry/nearest_triangle.hpp"
#include "geometry/surface_box.hpp"
#include "geometry/surface_edges.hpp"
#include "geometry/triangle_tree.hpp"
#include "geometry/winding_number.hpp"

namespace dmp::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point_of(const Vec& position) { return {position.x(), position.y(), position.z()}; }
const Vec& corner_of(const TriangleSurface& surface, int number) {
    return surface.corners[static_cast<std::size_t>(number)];
}

/// The corners of a triangle, those that another triangle has too at the front; and how many these are.
std::pair<std::array<int, 3>, int> shared_first(std::array<int, 3> corners, const std::array<int, 3>& other) {
    const auto own = std::stable_partition(corners.begin(), corners.end(),
                                           [&](int corner) { return std::ranges::count(other, corner) > 0; });
    return {corners, static_cast<int>(own - corners.begin())};
}

bool meet(const TriangleSurface& surface, int one, int other) {
    const auto& first = surface.triangles[static_cast<std::size_t>(one)];
    const auto& second = surface.triangles[static_cast<std::size_t>(other)];
    const auto [mine, shared] = shared_first(first, second);
    const auto yours = shared_first(second, first).first;
    const auto at = [&](int corner) { return point_of(corner_of(surface, corner)); };
    const Kernel::Triangle_3 a(at(mine[0]), at(mine[1]), at(mine[2])), b(at(yours[0]), at(yours[1]), at(yours[2]));
    if (a.is_degenerate() || b.is_degenerate()) return false;
    switch (shared) {
        case 0:
            return CGAL::do_intersect(a, b);
        case 1:
            return CGAL::do_intersect(Kernel::Segment_3(a[1], a[2]), b) ||
                   CGAL::do_intersect(Kernel::Segment_3(b[1], b[2]), a);
        case 2:
            // Folded flat upon each other about the edge they share.
            return CGAL::coplanar(a[0], a[1], a[2], b[2]) &&
                   CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::POSITIVE;
        default:
            return true;
    }
}

/// Counts the edges of one surface that go through triangles of another.
void count_crossings(const TriangleSurface& surface, const TriangleSurface& through, double tolerance,
                     SolidOverlap& found) {
    const TriangleTree tree(through);
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        const Vec& from = corner_of(surface, sides.front().low);
        const Vec& to = corner_of(surface, sides.front().high);
        tree.visit_box(from.cwiseMin(to), from.cwiseMax(to), [&](int triangle) {
            const auto& [a, b, c] = through.triangles[static_cast<std::size_t>(triangle)];
            const std::array<Vec, 3> corner{corner_of(through, a), corner_of(through, b), corner_of(through, c)};
            const Vec normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
            const double start = normal.dot(from - corner[0]), end = normal.dot(to - corner[0]);
            if (!(std::min(start, end) < -tolerance && std::max(start, end) > tolerance)) return;
            const Vec position = from + start / (start - end) * (to - from);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec side = (corner.at((k + 1) % 3) - corner.at(k)).normalized();
                if (normal.cross(side).dot(position - corner.at(k)) <= tolerance) return;
            }
            ++found.crossings;
            if (!found.first) found.first = position;
        });
    });
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const TriangleSurface& surface) {
    std::vector<std::pair<int, int>> found;
    const TriangleTree tree(surface);
    for (std::size_t position = 0; position < tree.order().size(); ++position) {
        const int triangle = tree.order()[position];
        const auto& [a, b, c] = tree.at(position);
        tree.visit_box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), [&](int other) {
            if (triangle < other && meet(surface, triangle, other)) found.emplace_back(triangle, other);
        });
    }
    std::ranges::sort(found);
    return found;
}

SolidOverlap overlap_of(const TriangleSurface& one, const TriangleSurface& other, double tolerance) {
    SolidOverlap found;
    if (one.triangles.empty() || other.triangles.empty()) return found;
    const Box first = box_of(one), second = box_of(other);
    const Box common{first.low.cwiseMax(second.low), first.high.cwiseMin(second.high)};
    if ((common.extent().array() <= tolerance).any()) return found;
    count_crossings(one, other, tolerance, found);
    count_crossings(other, one, tolerance, found);
    const WindingNumber in_one(one), in_other(other);
    // Bodies that touch along round surfaces share slivers, as their triangles differ: one place has to be deeper.
    const NearestTriangle skin(one, tolerance), other_skin(other, tolerance);
    constexpr int positions = 20;
    int both = 0;
    bool deep = found.crossings > 0;
    for (int i = 0; i < positions; ++i)
        for (int j = 0; j < positions; ++j)
            for (int k = 0; k < positions; ++k) {
                const Vec part = (Vec(i, j, k) + Vec::Constant(0.5)) / positions;
                const Vec position = common.low + part.cwiseProduct(common.extent());
                if (!in_one.inside(position) || !in_other.inside(position)) continue;
                ++both;
                if (deep || skin.nearest(position) || other_skin.nearest(position)) continue;
                deep = true;
                found.first = position;
            }
    if (deep) found.volume = common.extent().prod() * both / (positions * positions * positions);
    return found;
}

}  // namespace dmp::geometry
