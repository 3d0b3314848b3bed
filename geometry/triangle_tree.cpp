// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_tree.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numeric>

namespace dmp::geometry {

namespace {

constexpr std::int32_t in_a_leaf = 4;

/// Where a ray goes through a triangle (Moeller and Trumbore, Journal of Graphics Tools 2 (1997) 21).
std::optional<double> meet(const Vec& origin, const Vec& direction, const std::array<Vec, 3>& triangle) {
    const Vec first = triangle[1] - triangle[0], second = triangle[2] - triangle[0];
    const Vec across = direction.cross(second);
    const double determinant = first.dot(across);
    if (determinant == 0) return std::nullopt;
    const Vec from = origin - triangle[0];
    const double u = from.dot(across) / determinant;
    const Vec other = from.cross(first);
    const double v = direction.dot(other) / determinant;
    // A hair wider than the triangle: no ray slips through between two.
    constexpr double hair = 1e-12;
    if (u < -hair || v < -hair || u + v > 1 + hair) return std::nullopt;
    const double distance = second.dot(other) / determinant;
    if (!(distance > 0)) return std::nullopt;
    return distance;
}

/// How far along a ray a box begins; infinity where the ray misses it.
double entry(const Box& box, const Vec& origin, const Vec& inverse) {
    double begin = 0, end = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        double near = (box.low[axis] - origin[axis]) * inverse[axis];
        double far = (box.high[axis] - origin[axis]) * inverse[axis];
        if (near > far) std::swap(near, far);
        // Along an axis in which the ray does not move, 0 times infinity is no number: the box's side, which counts.
        if (near > begin) begin = near;
        if (far < end) end = far;
    }
    return begin <= end * (1 + 1e-14) ? begin : std::numeric_limits<double>::infinity();
}

}  // namespace

TriangleTree::TriangleTree(const TriangleSurface& surface) : order_(surface.triangles.size()) {
    if (order_.empty()) return;
    std::vector<Vec> middles(order_.size());
    triangles_.resize(order_.size());
    for (std::size_t t = 0; t < order_.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k)
            triangles_[t].at(k) = surface.corners[static_cast<std::size_t>(surface.triangles[t].at(k))];
        const auto& [a, b, c] = triangles_[t];
        middles[t] = 0.5 * (a.cwiseMin(b).cwiseMin(c) + a.cwiseMax(b).cwiseMax(c));
    }
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(order_.size());
    build(0, static_cast<std::int32_t>(order_.size()), middles);
    std::vector<std::array<Vec, 3>> in_order(triangles_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) in_order[k] = triangles_[static_cast<std::size_t>(order_[k])];
    triangles_ = std::move(in_order);
}

void TriangleTree::build(std::int32_t first, std::int32_t count, const std::vector<Vec>& middles) {
    const std::size_t number = nodes_.size();
    const auto begin = order_.begin() + first, end = begin + count;
    Node node{.box = {Vec::Constant(std::numeric_limits<double>::infinity()),
                      Vec::Constant(-std::numeric_limits<double>::infinity())},
              .first = first,
              .count = count};
    Box spread = node.box;
    for (auto t = begin; t != end; ++t) {
        for (const Vec& corner : triangles_[static_cast<std::size_t>(*t)]) {
            node.box.low = node.box.low.cwiseMin(corner);
            node.box.high = node.box.high.cwiseMax(corner);
        }
        spread.low = spread.low.cwiseMin(middles[static_cast<std::size_t>(*t)]);
        spread.high = spread.high.cwiseMax(middles[static_cast<std::size_t>(*t)]);
    }
    nodes_.push_back(node);
    if (count <= in_a_leaf) return;
    int axis = 0;
    spread.extent().maxCoeff(&axis);
    const std::int32_t half = count / 2;
    std::nth_element(begin, begin + half, end, [&](int a, int b) {
        const double x = middles[static_cast<std::size_t>(a)][axis], y = middles[static_cast<std::size_t>(b)][axis];
        return x != y ? x < y : a < b;
    });
    build(first, half, middles);
    nodes_[number].second = static_cast<std::int32_t>(nodes_.size());
    build(first + half, count - half, middles);
}

std::optional<RayHit> TriangleTree::first_hit(const Vec& origin, const Vec& direction,
                                              const std::function<bool(int)>& accept) const {
    const Vec inverse = direction.cwiseInverse();
    RayHit best{.distance = std::numeric_limits<double>::infinity()};
    struct Waiting {
        std::int32_t node;
        double entry;
    };
    std::array<Waiting, 64> waiting;
    std::size_t count = 0;
    const auto enter = [&](std::int32_t node) {
        return Waiting{node, entry(nodes_[static_cast<std::size_t>(node)].box, origin, inverse)};
    };
    if (!nodes_.empty()) waiting[count++] = enter(0);
    while (count > 0) {
        const Waiting here = waiting[--count];
        if (here.entry == std::numeric_limits<double>::infinity() || here.entry > best.distance) continue;
        const Node& node = nodes_[static_cast<std::size_t>(here.node)];
        if (node.second != 0) {
            Waiting near = enter(here.node + 1), far = enter(node.second);
            if (far.entry < near.entry) std::swap(near, far);
            waiting[count++] = far;
            waiting[count++] = near;
            continue;
        }
        for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
            const int triangle = order_[static_cast<std::size_t>(k)];
            const auto distance = meet(origin, direction, triangles_[static_cast<std::size_t>(k)]);
            if (!distance || *distance > best.distance) continue;
            if (*distance == best.distance && triangle > best.triangle) continue;
            if (accept(triangle)) best = {*distance, triangle};
        }
    }
    if (best.triangle < 0) return std::nullopt;
    return best;
}

}  // namespace dmp::geometry
