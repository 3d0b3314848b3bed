// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/closest_point.hpp"

namespace dmp {

NearestTriangle::NearestTriangle(const TriangleSurface& surface, double largest_distance)
    : largest_distance_(largest_distance) {
    if (!(largest_distance > 0)) throw std::invalid_argument("NearestTriangle: the largest distance must be positive");
    if (surface.triangles.empty()) return;
    Vec high = Vec::Constant(-std::numeric_limits<double>::infinity());
    low_ = -high;
    for (const auto& corners : surface.triangles) {
        std::array<Vec, 3>& triangle = triangles_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.at(k) = surface.corners[static_cast<std::size_t>(corners.at(k))];
            low_ = low_.cwiseMin(triangle.at(k));
            high = high.cwiseMax(triangle.at(k));
        }
    }
    for (const auto& [a, b, c] : triangles_) {
        const Vec centre = (a + b + c) / 3;
        const double square =
            std::max({(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()});
        balls_.push_back({centre, std::sqrt(square) * (1 + 1e-12)});
    }
    // Slightly more than asked for: rounding may not push a triangle out of a point's cell.
    const double reach = largest_distance * (1 + 1e-9) + 1e-14 * (high - low_).norm();
    low_ -= Vec::Constant(reach);
    high += Vec::Constant(reach);
    // No more than 2^20 cells along an axis: three indices make one key.
    cell_ = std::max(largest_distance, (high - low_).maxCoeff() / (1 << 20));

    const double farthest = reach + 0.5 * std::sqrt(3.0) * cell_;  // from a cell's middle
    std::vector<std::pair<std::uint64_t, std::int32_t>> found;     // cell, triangle
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const auto& [a, b, c] = triangles_[t];
        const Index first = index_of(a.cwiseMin(b).cwiseMin(c) - Vec::Constant(reach));
        const Index last = index_of(a.cwiseMax(b).cwiseMax(c) + Vec::Constant(reach));
        Index at{};
        for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
            for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
                for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) {
                    const Vec middle =
                        low_ + cell_ * Vec(static_cast<double>(at[0]) + 0.5, static_cast<double>(at[1]) + 0.5,
                                           static_cast<double>(at[2]) + 0.5);
                    if ((closest_on_triangle(middle, a, b, c) - middle).norm() <= farthest)
                        found.emplace_back(key_of(at), static_cast<std::int32_t>(t));
                }
    }
    std::ranges::sort(found);
    entries_.reserve(found.size());
    for (const auto& [cell, triangle] : found) {
        const auto end = static_cast<std::uint32_t>(entries_.size());
        cells_.try_emplace(cell, Cell{end, end}).first->second.end = end + 1;
        entries_.push_back(triangle);
    }
}

NearestTriangle::Index NearestTriangle::index_of(const Vec& point) const {
    Index index{};
    for (int axis = 0; axis < 3; ++axis)
        index.at(static_cast<std::size_t>(axis)) =
            static_cast<std::int64_t>(std::floor((point[axis] - low_[axis]) / cell_));
    return index;
}

std::uint64_t NearestTriangle::key_of(const Index& index) {
    std::uint64_t key = 0;
    for (const std::int64_t axis : index) key = key << 21U | static_cast<std::uint64_t>(axis);
    return key;
}

std::optional<SurfacePoint> NearestTriangle::nearest(const Vec& point) const {
    if (triangles_.empty() || !point.allFinite()) return std::nullopt;
    const Vec place = (point - low_) / cell_;
    if (place.minCoeff() < 0 || place.maxCoeff() >= 1 << 21) return std::nullopt;
    const auto cell = cells_.find(key_of(index_of(point)));
    if (cell == cells_.end()) return std::nullopt;
    SurfacePoint best{.distance = std::numeric_limits<double>::infinity()};
    double nearest_square = std::numeric_limits<double>::infinity();
    double nearest = nearest_square;
    for (std::uint32_t k = cell->second.begin; k < cell->second.end; ++k) {
        const std::int32_t t = entries_[k];
        const Ball& ball = balls_[static_cast<std::size_t>(t)];
        const double reach = ball.radius + nearest;
        if ((point - ball.centre).squaredNorm() > reach * reach) continue;
        const auto& [a, b, c] = triangles_[static_cast<std::size_t>(t)];
        const Vec here = closest_on_triangle(point, a, b, c);
        const double square = (here - point).squaredNorm();
        if (square >= nearest_square) continue;
        nearest_square = square;
        nearest = std::sqrt(square);
        best.point = here;
        best.triangle = t;
    }
    best.distance = nearest;
    if (!(best.distance <= largest_distance_)) return std::nullopt;
    return best;
}

}  // namespace dmp
