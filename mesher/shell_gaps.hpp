// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/local_thickness.hpp"
#include "geometry/nearest_triangle.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// The sheets of springs of a geometry in 3-D, each connected piece for itself, and how near they come to what is
/// beside them. No fluid passes an edge that touches a wall, a body or another sheet: it is held.
class ShellGaps {
  public:
    /// @param fewest how many fluid particles are to fit into a gap
    /// @param goes_on whether a place lies on a side of the box beyond which the scene goes on
    ShellGaps(const Geometry& geometry, const Scene& scene, double fewest,
              const std::function<bool(const Vec&)>& goes_on);

    /// As bodies a spacing thick, which is what their two layers of nodes take from the fluid. Facing outward.
    [[nodiscard]] const std::vector<TriangleSurface>& bodies() const { return bodies_; }

    /// Where a sheet meets what holds it at an angle, the room between them ends in a wedge, which is no gap.
    [[nodiscard]] bool is_in_a_wedge(const ThicknessSample& sample) const;

    /// Of each part with a free edge into whose gap to a solid or another sheet fewer particles fit: a line with the
    /// narrowest place.
    [[nodiscard]] std::vector<std::string> narrow_edges() const;

  private:
    using Edge = std::array<Vec, 2>;
    struct Sheet {
        const Part* part;
        TriangleSurface surface;
        NearestTriangle nearest;
        std::vector<Edge> free_edges;
    };

    [[nodiscard]] double distance_to_held(const Vec& position) const;
    /// How many particles fit between a place of a sheet's free edge and what is next to it.
    [[nodiscard]] double particles_beside(const Vec& position, const Sheet& own) const;

    double spacing_, fewest_;
    std::vector<NearestTriangle> solids_;
    std::vector<Sheet> sheets_;
    std::vector<Edge> held_;
    std::vector<TriangleSurface> bodies_;
};

}  // namespace dmp::mesher
