// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/orient_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/surface_crossings.hpp"

namespace dmp {

namespace {

/// A side of a triangle; forward: the triangle runs through it from the corner with the lower number.
struct Edge {
    int low, high;
    int triangle;
    bool forward;
};

std::vector<Edge> edges_of(const TriangleSurface& surface) {
    std::vector<Edge> edges;
    edges.reserve(3 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = surface.triangles[t].at(k), b = surface.triangles[t].at((k + 1) % 3);
            edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
        }
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
        return std::pair{std::pair{a.low, a.high}, a.triangle} < std::pair{std::pair{b.low, b.high}, b.triangle};
    });
    return edges;
}

struct Neighbour {
    int triangle;
    bool turns_alike;
};
using Neighbours = std::vector<std::vector<Neighbour>>;

Neighbours neighbours_of(const TriangleSurface& surface, Orientation& found) {
    const std::vector<Edge> edges = edges_of(surface);
    Neighbours neighbours(surface.triangles.size());
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next = std::find_if(
            edge, edges.end(), [&](const Edge& other) { return other.low != edge->low || other.high != edge->high; });
        if (next - edge == 1) {
            ++found.open_edges;
            if (!found.first_open)
                found.first_open = {surface.corners[static_cast<std::size_t>(edge->low)],
                                    surface.corners[static_cast<std::size_t>(edge->high)]};
        } else if (next - edge > 2) {
            ++found.many_fold;
        } else {
            const Edge& other = *(edge + 1);
            const bool alike = edge->forward != other.forward;
            neighbours[static_cast<std::size_t>(edge->triangle)].push_back({other.triangle, alike});
            neighbours[static_cast<std::size_t>(other.triangle)].push_back({edge->triangle, alike});
        }
        edge = next;
    }
    return neighbours;
}

/// The connected piece around a triangle; `turned` becomes whether each triangle has to be turned to be like the first.
std::vector<int> piece_around(int first, const Neighbours& neighbours, std::vector<std::int8_t>& turned,
                              Orientation& found) {
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
            }
        }
    }
    return piece;
}

/// Whether a triangle faces inward: on a line through it, in front of it lies an odd number of surfaces less than it
/// should, if what the line meets first goes in, next out, and so on.
bool faces_inward(const TriangleSurface& surface, int triangle) {
    const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
    // Weights without a common measure: not through the corners or edges of others where drawings are regular.
    const Vec through = 0.41421356 * surface.corners[static_cast<std::size_t>(a)] +
                        0.31783725 * surface.corners[static_cast<std::size_t>(b)] +
                        0.26794919 * surface.corners[static_cast<std::size_t>(c)];
    const SurfaceCrossings crossings(surface, {{through.z(), through.y(), 1, 1}});
    bool goes_in = true;
    for (const Crossing& crossing : crossings.of(0, 0)) {
        if (crossing.triangle == triangle) return (crossing.direction > 0) != goes_in;
        goes_in = !goes_in;
    }
    return false;
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
        if (turned[t] < 0) pieces.push_back(piece_around(static_cast<int>(t), neighbours, turned, found));
    found.pieces = pieces.size();
    const auto turn = [&](int triangle) {
        auto& corners = surface.triangles[static_cast<std::size_t>(triangle)];
        std::swap(corners[1], corners[2]);
    };
    for (const auto& piece : pieces) {
        // Seen as they were drawn, what counts on a line are its crossings, not their senses.
        const int seen = most_visible(surface, piece);
        const bool inward = faces_inward(surface, seen);
        const bool all = inward != (turned[static_cast<std::size_t>(seen)] != 0);
        for (const int triangle : piece)
            if (all != (turned[static_cast<std::size_t>(triangle)] != 0)) {
                turn(triangle);
                ++found.turned;
            }
    }
    return found;
}

}  // namespace dmp
