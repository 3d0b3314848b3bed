// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/nearest_curve.hpp"
#include "geometry/nearest_triangle.hpp"
#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// What moves until it follows the geometry, by who has the room first: solids of springs with bonds_within, then
/// fluids.
[[nodiscard]] std::vector<const Part*> fitted_parts(const Scene& scene);

/// The surface that the geometry gives one fluid, or a solid with bonds_within: where the fluid ends at a wall or at
/// another fluid. Sides of the box that are periodic or planes of symmetry are none, nor is what lies in a body or a
/// fluid that has the room before it.
class CadSurface {
  public:
    /// A place on the surface that stands for a piece of it.
    struct Sample {
        Vec point;
        Vec normal;         ///< out of the fluid
        double weight = 0;  ///< length [m] or area [m^2] of the piece
    };

    /// @param space the box, its periods and planes of symmetry
    /// @param reach how far nearest() looks [m]
    CadSurface(const Geometry& geometry, const Scene& scene, const ParticleSpace& space, const Part& fluid,
               double reach);

    /// Evenly over the surface, about half a spacing apart; further where there would be more than two million.
    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

    /// The nearest point of the surface, across periodic sides too; nothing where it is further than the reach.
    [[nodiscard]] std::optional<Projection> nearest(const Vec& point) const;
    /// Of a point on the surface, the way out of the fluid: the normal of the nearest sample, if one is within a
    /// spacing.
    [[nodiscard]] std::optional<Vec> way_out(const Vec& point) const;

  private:
    void sample_curves(const Geometry& geometry, const Part& fluid, const std::vector<const Part*>& fluids);
    void sample_solids(const Geometry& geometry, const Scene& scene, const Part& fluid);
    [[nodiscard]] bool is_on_a_side(const Vec& point) const;
    [[nodiscard]] Vec back_in_box(Vec point) const;
    [[nodiscard]] std::optional<Projection> nearest_here(const Vec& point) const;

    const ParticleSpace& space_;
    double reach_;
    std::vector<Sample> samples_;
    CellGrid grid_;  ///< of the samples
    std::optional<NearestCurve> curves_;
    std::optional<NearestTriangle> triangles_;
};

}  // namespace dmp::mesher
