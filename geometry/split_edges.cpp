// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/split_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "geometry/surface_edges.hpp"
#include "geometry/triangle_tree.hpp"

namespace dmp::geometry {

namespace {

std::vector<SurfaceEdge> open_edges_of(const TriangleSurface& surface) {
    std::vector<SurfaceEdge> open;
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        if (sides.size() == 1) open.push_back(sides.front());
    });
    return open;
}

/// A corner on an open edge, and how far along it.
struct Junction {
    std::size_t edge;
    double along;
    int corner;
};

std::vector<Junction> junctions(const TriangleSurface& surface, const std::vector<SurfaceEdge>& open, double distance) {
    TriangleSurface edges;  // triangles without width
    edges.corners = surface.corners;
    std::vector<int> ends;
    for (const SurfaceEdge& edge : open) {
        edges.triangles.push_back({edge.from(), edge.to(), edge.to()});
        ends.push_back(edge.low);
        ends.push_back(edge.high);
    }
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const TriangleTree tree(edges);
    std::vector<Junction> found;
    const Vec margin = Vec::Constant(distance);
    for (const int corner : ends) {
        const Vec& position = surface.corners[static_cast<std::size_t>(corner)];
        tree.visit_box(position - margin, position + margin, [&](int edge) {
            const auto& [from, to, same] = edges.triangles[static_cast<std::size_t>(edge)];
            if (corner == from || corner == to) return;
            const Vec& a = surface.corners[static_cast<std::size_t>(from)];
            const Vec side = surface.corners[static_cast<std::size_t>(to)] - a;
            const double length = side.norm(), along = (position - a).dot(side) / length;
            if (along <= distance || along >= length - distance) return;
            if ((position - a - along / length * side).norm() <= distance)
                found.push_back({static_cast<std::size_t>(edge), along, corner});
        });
    }
    std::ranges::sort(found, [](const Junction& a, const Junction& b) {
        return std::pair{a.edge, a.along} < std::pair{b.edge, b.along};
    });
    return found;
}

}  // namespace

std::size_t split_at_t_junctions(TriangleSurface& surface, double distance) {
    std::size_t count = 0;
    // A triangle is divided at one of its sides at a time; what is left of it comes again. The bound is for geometries
    // that are all finer than the distance.
    bool again = true;
    for (int pass = 0; again && pass < 100; ++pass) {
        again = false;
        const std::vector<SurfaceEdge> open = open_edges_of(surface);
        const std::vector<Junction> found = junctions(surface, open, distance);
        std::vector<char> divided(surface.triangles.size(), 0);
        for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
            while (end < found.size() && found[end].edge == found[begin].edge) ++end;
            const SurfaceEdge& edge = open[found[begin].edge];
            const auto number = static_cast<std::size_t>(edge.triangle);
            if (divided[number] != 0) continue;
            const std::array<int, 3> corners = surface.triangles[number];
            const int opposite = corners[0] + corners[1] + corners[2] - edge.low - edge.high;
            std::vector<int> chain{edge.from()};
            for (std::size_t k = begin; k < end; ++k)
                if (found[k].corner != opposite) chain.push_back(found[k].corner);
            if (chain.size() == 1) continue;
            chain.push_back(edge.to());
            divided[number] = 1;
            again = true;
            count += chain.size() - 2;
            surface.triangles[number] = {chain[0], chain[1], opposite};
            for (std::size_t k = 1; k + 1 < chain.size(); ++k)
                surface.triangles.push_back({chain[k], chain[k + 1], opposite});
        }
    }
    return count;
}

}  // namespace dmp::geometry
