// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// Where a ray meets a surface.
struct RayHit {
    double distance = 0;  ///< in lengths of the ray's direction
    int triangle = -1;    ///< index into TriangleSurface::triangles
};

/// A tree of boxes around the triangles of a surface: each box is divided at the median of its triangles' middles. It
/// keeps its own copy of the triangles and is not changed after construction, so that any number of threads may ask it.
class TriangleTree {
  public:
    struct Node {
        Box box;
        std::int32_t first = 0, count = 0;  ///< of the triangles below it, in order()
        std::int32_t second = 0;            ///< its second child, the first one follows the node; 0: it has none
    };

    explicit TriangleTree(const TriangleSurface& surface);

    /// Parents stand before their children; empty for a surface without triangles.
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    /// Numbers of triangles as the nodes have them.
    [[nodiscard]] const std::vector<int>& order() const { return order_; }
    /// The corners of the triangle at a place of order().
    [[nodiscard]] const std::array<Vec, 3>& at(std::size_t position) const { return triangles_[position]; }

    /// Calls visit(triangle) for each triangle whose own box meets a box.
    template <class Visit>
    void visit_box(const Vec& low, const Vec& high, const Visit& visit) const;

    /// The first triangle that a ray meets and that is accepted.
    [[nodiscard]] std::optional<RayHit> first_hit(const Vec& origin, const Vec& direction,
                                                  const std::function<bool(int)>& accept) const;

  private:
    void build(std::int32_t first, std::int32_t count, const std::vector<Vec>& middles);

    std::vector<Node> nodes_;
    std::vector<int> order_;
    std::vector<std::array<Vec, 3>> triangles_;  ///< in this order
};

template <class Visit>
void TriangleTree::visit_box(const Vec& low, const Vec& high, const Visit& visit) const {
    const auto apart = [&](const Vec& other_low, const Vec& other_high) {
        return (other_low.array() > high.array()).any() || (other_high.array() < low.array()).any();
    };
    std::array<std::int32_t, 64> waiting;  // deeper than any tree of halves
    std::size_t count = 0;
    if (!nodes_.empty()) waiting[count++] = 0;
    while (count > 0) {
        const std::int32_t number = waiting[--count];
        const Node& node = nodes_[static_cast<std::size_t>(number)];
        if (apart(node.box.low, node.box.high)) continue;
        if (node.second != 0) {
            waiting[count++] = node.second;
            waiting[count++] = number + 1;
            continue;
        }
        for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
            const auto& [a, b, c] = triangles_[static_cast<std::size_t>(k)];
            if (!apart(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)))
                visit(order_[static_cast<std::size_t>(k)]);
        }
    }
}

}  // namespace dmp::geometry
