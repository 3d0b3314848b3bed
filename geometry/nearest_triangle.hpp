// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// The nearest point of a surface.
struct SurfacePoint {
    Vec point = Vec::Zero();
    double distance = 0;  ///< [m]
    int triangle = -1;    ///< index into TriangleSurface::triangles; of several equally near ones the first
};

/// The nearest point of a surface, for many points and distances up to a limit: the band around a surface. Triangles
/// lie in a tree of boxes, halved along the longest side until four are left; a search goes into the nearer half first
/// and leaves out what is further than the best so far. After construction it is never changed, so any number of
/// threads may ask it.
class NearestTriangle {
  public:
    /// Of no surface: finds nothing.
    NearestTriangle() = default;
    /// @param largest_distance how far to look [m]; must be positive (throws std::invalid_argument).
    NearestTriangle(const TriangleSurface& surface, double largest_distance);

    /// Nothing where all triangles are further than the largest distance.
    [[nodiscard]] std::optional<SurfacePoint> nearest(const Vec& point) const;
    /// The same, faster where a point of the surface is known that is near, as the last answer of a walk.
    [[nodiscard]] std::optional<SurfacePoint> nearest(const Vec& point, const Vec& on_surface) const;

  private:
    struct Triangle {
        std::array<Vec, 3> corner;
        std::int32_t number;
    };
    struct Node {
        Vec low, high;
        std::uint32_t begin = 0, end = 0;  ///< of its triangles
        std::uint32_t second = 0;          ///< its second half; the first one follows it. 0: a leaf
    };
    std::uint32_t build(std::span<Triangle> triangles, std::uint32_t begin);
    [[nodiscard]] std::optional<SurfacePoint> within(const Vec& point, double square) const;
    static double square_to(const Node& node, const Vec& point);

    double largest_distance_ = 0;
    std::vector<Triangle> triangles_;  ///< leaf after leaf
    std::vector<Node> nodes_;
};

}  // namespace dmp::geometry
