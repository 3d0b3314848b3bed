// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp {

/// The nearest point of a surface.
struct SurfacePoint {
    Vec point = Vec::Zero();
    double distance = 0;  ///< [m]
    int triangle = -1;    ///< index into TriangleSurface::triangles; of several equally near ones the first
};

/// The nearest point of a surface, for many points and distances up to a limit: the band around a surface. Triangles
/// are sorted once into the cells of a grid, of which only those near the surface exist. After construction it is never
/// changed, so any number of threads may ask it.
class NearestTriangle {
  public:
    /// Of no surface: finds nothing.
    NearestTriangle() = default;
    /// @param largest_distance how far to look [m]; must be positive (throws std::invalid_argument). Memory grows with
    /// the surface's area over its square.
    NearestTriangle(const TriangleSurface& surface, double largest_distance);

    /// Nothing where all triangles are further than the largest distance.
    [[nodiscard]] std::optional<SurfacePoint> nearest(const Vec& point) const;

  private:
    struct Cell {
        std::uint32_t begin = 0, end = 0;  ///< of its triangles, in entries_
    };
    /// A ball around a triangle: most are too far away already.
    struct Ball {
        Vec centre;
        double radius;
    };
    using Index = std::array<std::int64_t, 3>;
    [[nodiscard]] Index index_of(const Vec& point) const;
    static std::uint64_t key_of(const Index& index);

    double largest_distance_ = 0;
    double cell_ = 0;  ///< edge of a grid cell [m]
    Vec low_ = Vec::Zero();
    std::vector<std::array<Vec, 3>> triangles_;
    std::vector<Ball> balls_;  ///< by triangle
    std::unordered_map<std::uint64_t, Cell> cells_;
    std::vector<std::int32_t> entries_;  ///< numbers of triangles, ascending in each cell
};

}  // namespace dmp
