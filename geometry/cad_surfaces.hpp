// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// The surfaces of the 3-D geometry that gmsh has open, as triangles in metres that share their corners. A geometry
/// with formulas is meshed first, finely enough to follow its curves to within the chord error.
class CadSurfaces {
  public:
    explicit CadSurfaces(const GeometryOptions& options);

    /// The triangles of some surfaces.
    [[nodiscard]] TriangleSurface surfaces(const std::vector<int>& tags) const;
    /// The surface around some volumes; what lies between two of them does not count.
    [[nodiscard]] TriangleSurface boundary(const std::vector<int>& volumes) const;
    [[nodiscard]] Vec point(int tag) const;

  private:
    using Triangle = std::array<std::size_t, 3>;  ///< numbers of gmsh's nodes

    void make_mesh() const;
    const GeometryOptions& options_;
    std::map<std::size_t, Vec> nodes_;                ///< [m]
    std::map<int, std::vector<Triangle>> triangles_;  ///< by surface
};

}  // namespace dmp::geometry
