// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/orient_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "geometry/surface_crossings.hpp"
#include "geometry/surface_edges.hpp"

namespace dmp::geometry {

namespace {

struct Neighbour {
    int triangle;
    bool turns_alike;
};
using Neighbours = std::vector<std::vector<Neighbour>>;

Neighbours neighbours_of(const TriangleSurface& surface, Orientation& found) {
    Neighbours neighbours(surface.triangles.size());
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        const SurfaceEdge& edge = sides.front();
        if (sides.size() == 1) {
            ++found.open_edges;
            if (!found.first_open)
                found.first_open = {surface.corners[static_cast<std::size_t>(edge.low)],
                                    surface.corners[static_cast<std::size_t>(edge.high)]};
        } else if (sides.size() > 2) {
            ++found.many_fold;
            if (!found.first_unclear)
                found.first_unclear = 0.5 * (surface.corners[static_cast<std::size_t>(edge.low)] +
                                             surface.corners[static_cast<std::size_t>(edge.high)]);
        } else {
            const SurfaceEdge& other = sides[1];
            const bool alike = edge.forward != other.forward;
            neighbours[static_cast<std::size_t>(edge.triangle)].push_back({other.triangle, alike});
            neighbours[static_cast<std::size_t>(other.triangle)].push_back({edge.triangle, alike});
        }
    });
    return neighbours;
}

/// The connected piece around a triangle; `turned` becomes whether each triangle has to be turned to be like the first.
std::vector<int> piece_around(const TriangleSurface& surface, int first, const Neighbours& neighbours,
                              std::vector<std::int8_t>& turned, Orientation& found) {
    std::vector<int> piece{first};
    turned[static_cast<std::size_t>(first)] = 0;
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const auto here = static_cast<std::size_t>(piece[k]);
        for (const Neighbour& neighbour : neighbours[here]) {
            const auto there = static_cast<std::size_t>(neighbour.triangle);
            const auto wanted = static_cast<std::int8_t>(neighbour.turns_alike ? turned[here] : 1 - turned[here]);
            if (turned[there] < 0) {
                turned[there] = wanted;
                piece.push_back(neighbour.triangle);
            } else if (turned[there] != wanted && here < there) {
                ++found.contradicted;
                if (!found.first_unclear)
                    found.first_unclear = surface.corners[static_cast<std::size_t>(surface.triangles[here].front())];
            }
        }
    }
    return piece;
}

/// Whether triangles face inward: on a line through one, in front of it lies an odd number of surfaces less than it
/// should, if what the line meets first goes in, next out, and so on.
std::vector<char> face_inward(const TriangleSurface& surface, const std::vector<int>& triangles) {
    std::vector<LineRow> rows;
    for (const int triangle : triangles) {
        const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
        // Weights without a common measure: not through the corners or edges of others where geometries are regular.
        const Vec through = 0.41421356 * surface.corners[static_cast<std::size_t>(a)] +
                            0.31783725 * surface.corners[static_cast<std::size_t>(b)] +
                            0.26794919 * surface.corners[static_cast<std::size_t>(c)];
        rows.push_back({through.z(), through.y(), 1, 1});
    }
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return rows[k].z; });
    std::vector<LineRow> sorted;
    for (const std::size_t k : order) sorted.push_back(rows[k]);
    const SurfaceCrossings crossings(surface, sorted);
    std::vector<char> inward(triangles.size(), 0);
    for (std::size_t row = 0; row < order.size(); ++row) {
        bool goes_in = true;
        for (const Crossing& crossing : crossings.of(row, 0)) {
            if (crossing.triangle == triangles[order[row]]) {
                inward[order[row]] = (crossing.direction > 0) != goes_in ? 1 : 0;
                break;
            }
            goes_in = !goes_in;
        }
    }
    return inward;
}

/// The triangle that is seen largest along x.
int most_visible(const TriangleSurface& surface, const std::vector<int>& piece) {
    const auto shadow = [&](int triangle) {
        const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
        const Vec& corner = surface.corners[static_cast<std::size_t>(a)];
        return std::abs((surface.corners[static_cast<std::size_t>(b)] - corner)
                            .cross(surface.corners[static_cast<std::size_t>(c)] - corner)
                            .x());
    };
    return *std::ranges::max_element(piece, {}, shadow);
}

}  // namespace

Orientation orient_outward(TriangleSurface& surface) {
    Orientation found;
    const Neighbours neighbours = neighbours_of(surface, found);
    std::vector<std::int8_t> turned(surface.triangles.size(), -1);  // -1: not looked at yet
    std::vector<std::vector<int>> pieces;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        if (turned[t] < 0) pieces.push_back(piece_around(surface, static_cast<int>(t), neighbours, turned, found));
    found.pieces = pieces.size();
    const auto turn = [&](int triangle) {
        auto& corners = surface.triangles[static_cast<std::size_t>(triangle)];
        std::swap(corners[1], corners[2]);
    };
    // Seen as they were drawn: what counts on a line are its crossings, not their senses.
    std::vector<int> seen;
    for (const auto& piece : pieces) seen.push_back(most_visible(surface, piece));
    const std::vector<char> inward = face_inward(surface, seen);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const bool all = (inward[k] != 0) != (turned[static_cast<std::size_t>(seen[k])] != 0);
        for (const int triangle : pieces[k])
            if (all != (turned[static_cast<std::size_t>(triangle)] != 0)) {
                turn(triangle);
                ++found.turned;
            }
    }
    // A piece that crosses itself has parts that face out and others that face in: the one looked at may be the
    // smaller.
    if (found.closed() && surface.enclosed_volume() < 0) {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) turn(static_cast<int>(t));
        found.turned = surface.triangles.size() - found.turned;
    }
    return found;
}

}  // namespace dmp::geometry
