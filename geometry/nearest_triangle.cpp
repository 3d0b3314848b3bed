// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_triangle.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/closest_point.hpp"

namespace dmp::geometry {

namespace {

constexpr std::size_t leaf_size = 4;
constexpr std::size_t deepest = 48;  // halves of 2^31 triangles are 31 deep

}  // namespace

NearestTriangle::NearestTriangle(const TriangleSurface& surface, double largest_distance)
    : largest_distance_(largest_distance) {
    if (!(largest_distance > 0)) throw std::invalid_argument("NearestTriangle: the largest distance must be positive");
    if (surface.triangles.empty()) return;
    triangles_.reserve(surface.triangles.size());
    for (const auto& corners : surface.triangles) {
        Triangle triangle{{}, static_cast<std::int32_t>(triangles_.size())};
        for (std::size_t k = 0; k < 3; ++k)
            triangle.corner.at(k) = surface.corners[static_cast<std::size_t>(corners.at(k))];
        triangles_.push_back(triangle);
    }
    nodes_.reserve(triangles_.size());
    build(triangles_, 0);
}

/// The tree over some triangles, of which `begin` lie before; returns its root.
std::uint32_t NearestTriangle::build(std::span<Triangle> triangles, std::uint32_t begin) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    const Vec far = Vec::Constant(std::numeric_limits<double>::infinity());
    Node node{far, -far, begin, begin + static_cast<std::uint32_t>(triangles.size()), 0};
    for (const auto& [corner, index] : triangles)
        for (const Vec& point : corner) {
            node.low = node.low.cwiseMin(point);
            node.high = node.high.cwiseMax(point);
        }
    nodes_.push_back(node);
    if (triangles.size() <= leaf_size) return number;
    Eigen::Index axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const std::size_t half = triangles.size() / 2;
    const auto position = [axis](const Triangle& t) {
        return t.corner[0][axis] + t.corner[1][axis] + t.corner[2][axis];
    };
    std::ranges::nth_element(triangles, triangles.begin() + static_cast<std::ptrdiff_t>(half), {}, position);
    build(triangles.first(half), begin);
    const std::uint32_t second = build(triangles.subspan(half), begin + static_cast<std::uint32_t>(half));
    nodes_[number].second = second;
    return number;
}

double NearestTriangle::square_to(const Node& node, const Vec& point) {
    return (point - point.cwiseMax(node.low).cwiseMin(node.high)).squaredNorm();
}

std::optional<SurfacePoint> NearestTriangle::nearest(const Vec& point) const {
    return within(point, largest_distance_ * largest_distance_);
}

std::optional<SurfacePoint> NearestTriangle::nearest(const Vec& point, const Vec& on_surface) const {
    // How far the triangle is from where its point was rounded to does not matter: 1e-6 of the limit is added.
    const double distance = std::min(largest_distance_, (point - on_surface).norm() + 1e-6 * largest_distance_);
    return within(point, distance * distance);
}

std::optional<SurfacePoint> NearestTriangle::within(const Vec& point, double square_of_reach) const {
    if (nodes_.empty() || !point.allFinite()) return std::nullopt;
    // A little more than asked for: rounding may not leave out what is as near as that.
    constexpr double slack = 1 + 1e-12;
    double nearest_square = square_of_reach * slack;
    SurfacePoint best;
    struct Open {
        double square;
        std::uint32_t node;
    };
    std::array<Open, deepest> open;  // NOLINT(cppcoreguidelines-pro-type-member-init): a stack, empty
    std::size_t waiting = 0;
    open.at(waiting++) = {square_to(nodes_.front(), point), 0};
    while (waiting > 0) {
        auto [square, number] = open.at(--waiting);
        if (square > nearest_square * slack) continue;
        while (nodes_[number].second != 0) {
            std::uint32_t nearer = number + 1, further = nodes_[number].second;
            double to_nearer = square_to(nodes_[nearer], point), to_further = square_to(nodes_[further], point);
            if (to_further < to_nearer) {
                std::swap(nearer, further);
                std::swap(to_nearer, to_further);
            }
            if (to_further <= nearest_square * slack) open.at(waiting++) = {to_further, further};
            number = nearer;
            square = to_nearer;
            if (square > nearest_square * slack) break;
        }
        if (square > nearest_square * slack) continue;
        for (std::uint32_t k = nodes_[number].begin; k < nodes_[number].end; ++k) {
            const auto& [corner, index] = triangles_[k];
            const Vec here = closest_on_triangle(point, corner[0], corner[1], corner[2]);
            const double to_here = (here - point).squaredNorm();
            if (to_here > nearest_square || (to_here == nearest_square && best.triangle >= 0 && index > best.triangle))
                continue;
            nearest_square = to_here;
            best.point = here;
            best.triangle = index;
        }
    }
    best.distance = (best.point - point).norm();
    if (best.triangle < 0 || !(best.distance <= largest_distance_)) return std::nullopt;
    return best;
}

}  // namespace dmp::geometry
