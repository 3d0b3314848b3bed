// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "base/disjoint_sets.hpp"
#include "geometry/surface_edges.hpp"

namespace dmp::geometry {

bool SurfacePiece::has_no_volume() const { return closed && std::abs(volume) <= 1e-9 * area * box.extent().maxCoeff(); }

SurfacePieces::SurfacePieces(const TriangleSurface& surface) : piece_of_(surface.triangles.size()) {
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    DisjointSets together(piece_of_.size());
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        if (sides.size() == 2)
            together.join(static_cast<std::size_t>(sides[0].triangle), static_cast<std::size_t>(sides[1].triangle));
    });
    for (std::size_t t = 0; t < piece_of_.size(); ++t) {
        const std::size_t first = together.find(t);
        if (first == t) {
            piece_of_[t] = pieces_.size();
            pieces_.emplace_back().box = {Vec::Constant(std::numeric_limits<double>::infinity()),
                                          Vec::Constant(-std::numeric_limits<double>::infinity())};
        } else {
            piece_of_[t] = piece_of_[first];
        }
        SurfacePiece& piece = pieces_[piece_of_[t]];
        piece.triangles.push_back(static_cast<int>(t));
        const auto corner = [&](std::size_t k) -> const Vec& {
            return surface.corners[static_cast<std::size_t>(surface.triangles[t].at(k))];
        };
        for (std::size_t k = 0; k < 3; ++k) {
            piece.box.low = piece.box.low.cwiseMin(corner(k));
            piece.box.high = piece.box.high.cwiseMax(corner(k));
        }
        const auto first_corner = static_cast<std::size_t>(surface.triangles[first][0]);
        const Vec& origin = surface.corners[first_corner];  // near the surface, for the sake of rounding
        piece.area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
        piece.volume += (corner(0) - origin).dot((corner(1) - origin).cross(corner(2) - origin)) / 6;
    }
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        // On an edge with many sides, a piece is closed if two of them are its own.
        for (const SurfaceEdge& side : sides) {
            const std::size_t here = piece_of(side.triangle);
            if (std::ranges::count_if(sides,
                                      [&](const SurfaceEdge& other) { return piece_of(other.triangle) == here; }) != 2)
                pieces_[here].closed = false;
        }
    });
}

std::size_t separate_closed_pieces(TriangleSurface& surface) {
    const EdgeCounts before = count_edges(surface);
    if (before.many_fold == 0) return 0;
    const SurfacePieces pieces(surface);
    // Pieces that are not closed keep their corners.
    constexpr int nobody = -2, open_pieces = -1;
    std::vector<int> owner(surface.corners.size(), nobody);
    const auto each_corner = [&](const SurfacePiece& piece, const auto& visit) {
        for (const int t : piece.triangles)
            for (int& corner : surface.triangles[static_cast<std::size_t>(t)]) visit(corner);
    };
    for (const SurfacePiece& piece : pieces.all())
        if (!piece.closed)
            each_corner(piece, [&](int& corner) { owner[static_cast<std::size_t>(corner)] = open_pieces; });
    int number = 0;
    for (const SurfacePiece& piece : pieces.all()) {
        if (!piece.closed) continue;
        std::map<int, int> ghosts;
        each_corner(piece, [&](int& corner) {
            int& known = owner[static_cast<std::size_t>(corner)];
            if (known == nobody) known = number;
            if (known == number) return;
            const auto [copy, is_new] = ghosts.try_emplace(corner, static_cast<int>(surface.corners.size()));
            if (is_new) {
                const Vec position = surface.corners[static_cast<std::size_t>(corner)];
                surface.corners.push_back(position);
                owner.push_back(number);
            }
            corner = copy->second;
        });
        ++number;
    }
    return before.many_fold - count_edges(surface).many_fold;
}

TriangleSurface part_of(const TriangleSurface& surface, const std::vector<int>& triangles) {
    // Sorted, not by a table of all corners: there may be as many parts as triangles.
    std::vector<int> used;
    for (const int t : triangles)
        for (const int corner : surface.triangles[static_cast<std::size_t>(t)]) used.push_back(corner);
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    TriangleSurface part;
    for (const int corner : used) part.corners.push_back(surface.corners[static_cast<std::size_t>(corner)]);
    for (const int t : triangles)
        for (int& corner : part.triangles.emplace_back(surface.triangles[static_cast<std::size_t>(t)]))
            corner = static_cast<int>(std::ranges::lower_bound(used, corner) - used.begin());
    return part;
}

}  // namespace dmp::geometry
