// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding_vote.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/surface_pieces.hpp"
#include "geometry/winding_number.hpp"

namespace dmp::geometry {

namespace {

/// The k-th number of a sequence that fills [0, 1) evenly (Halton, Numerische Mathematik 2 (1960) 84).
double halton(int k, int base) {
    double sum = 0, part = 1;
    for (; k > 0; k /= base) {
        part /= base;
        sum += part * (k % base);
    }
    return sum;
}

struct Middle {
    Vec position;
    Vec normal;  ///< times twice the area
};

Middle middle_of(const TriangleSurface& surface, int triangle) {
    const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
    const Vec& first = surface.corners[static_cast<std::size_t>(a)];
    const Vec& second = surface.corners[static_cast<std::size_t>(b)];
    const Vec& third = surface.corners[static_cast<std::size_t>(c)];
    return {(first + second + third) / 3, (second - first).cross(third - first)};
}

/// The mean of the winding number on a piece's own triangles, between their two sides: 1/2 on a closed one that faces
/// outward, -1/2 if it faces inward, 0 on a flat sheet.
double mean_on(const TriangleSurface& piece) {
    const WindingNumber winding(piece);
    const std::size_t stride = std::max<std::size_t>(1, piece.triangles.size() / 256);
    double sum = 0, weight = 0;
    for (std::size_t t = 0; t < piece.triangles.size(); t += stride) {
        const auto [position, normal] = middle_of(piece, static_cast<int>(t));
        const double twice_area = normal.norm();
        if (!(twice_area > 0)) continue;
        const Vec off = 1e-6 / std::sqrt(twice_area) * normal;
        sum += twice_area * 0.5 * (winding.at(position + off) + winding.at(position - off));
        weight += twice_area;
    }
    return weight > 0 ? sum / weight : 0;
}

void turn(TriangleSurface& surface, const std::vector<int>& triangles) {
    for (const int t : triangles) {
        auto& corners = surface.triangles[static_cast<std::size_t>(t)];
        std::swap(corners[1], corners[2]);
    }
}

}  // namespace

WindingVote vote_on(const TriangleSurface& surface) {
    WindingVote vote;
    const WindingNumber winding(surface);
    if (surface.triangles.empty()) return vote;
    const Box box = TriangleTree(surface).nodes().front().box;
    constexpr int positions = 20000;
    int inside = 0, unclear = 0, somewhat = 0;
    for (int k = 1; k <= positions; ++k) {
        const Vec part(halton(k, 2), halton(k, 3), halton(k, 5));
        const double here = winding.at(box.low + part.cwiseProduct(box.extent()));
        inside += here > 0.5 ? 1 : 0;
        somewhat += here > 0.25 ? 1 : 0;
        unclear += here > 0.25 && here < 0.75 ? 1 : 0;
    }
    vote.volume = box.extent().prod() * inside / positions;
    if (somewhat > 0) vote.doubt = static_cast<double>(unclear) / somewhat;
    return vote;
}

std::vector<int> turn_open_pieces(TriangleSurface& surface) {
    std::vector<int> sheets;
    const SurfacePieces pieces(surface);
    std::vector<const SurfacePiece*> open;
    for (const SurfacePiece& piece : pieces.all()) {
        if (piece.closed) continue;
        const double mean = mean_on(part_of(surface, piece.triangles));
        if (std::abs(mean) < 0.25) {
            sheets.insert(sheets.end(), piece.triangles.begin(), piece.triangles.end());
            continue;
        }
        if (mean < 0) turn(surface, piece.triangles);
        open.push_back(&piece);
    }
    if (pieces.all().size() > 1) {
        const WindingNumber all(surface);
        std::vector<const SurfacePiece*> within;
        for (const SurfacePiece* piece : open) {
            const auto [position, normal] = middle_of(surface, piece->triangles.front());
            const Vec outside = position + 1e-6 / std::sqrt(normal.norm()) * normal;
            if (all.at(outside) - WindingNumber(part_of(surface, piece->triangles)).at(outside) > 0.5)
                within.push_back(piece);
        }
        for (const SurfacePiece* piece : within) turn(surface, piece->triangles);
    }
    std::ranges::sort(sheets);
    return sheets;
}

}  // namespace dmp::geometry
