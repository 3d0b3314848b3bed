// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// What a file of triangles holds: one surface, each triangle of which belongs to a group.
struct TriangleSoup {
    TriangleSurface surface;
    std::vector<int> group;          ///< by triangle: index into names
    std::vector<std::string> names;  ///< of the groups, in the file's order, as written; "": without a name
};

/// Puts a soup together of corners and polygons. Corners with equal coordinates are one; triangles without an area are
/// left out and counted.
class SoupBuilder {
  public:
    SoupBuilder();

    /// The number of the corner at this place, for add_triangle and add_polygon. It must be finite.
    int corner(const Vec& position);
    /// Triangles that follow belong to this group.
    void begin_group(const std::string& name);
    void add_triangle(int a, int b, int c);
    /// As triangles (split_polygon); false where it has too many corners.
    [[nodiscard]] bool add_polygon(std::span<const int> corners);
    /// The soup, of groups that have triangles.
    [[nodiscard]] TriangleSoup finish();

  private:
    struct Hash {
        std::size_t operator()(const std::array<double, 3>& position) const;
    };

    TriangleSoup soup_;
    int group_ = 0;
    std::unordered_map<std::array<double, 3>, int, Hash> corners_;
    std::unordered_map<std::string, int> groups_;
};

}  // namespace dmp::geometry
