// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "scene/scene.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The body acceleration g of flow.acceleration: formulas of t, and of x, y, z where they depend on position.
class BodyForce {
  public:
    using Momentum = std::array<double, 3>;  ///< of all ranks [N]

    BodyForce(const Scene& scene, const ParticleStore& particles);

    /// g at time t along the axes on which it is uniform, 0 along the others [m/s^2]: what continues the pressure in
    /// walls.
    [[nodiscard]] std::array<double, 3> uniform(double t) const;
    /// The same without periodic axes, along which no pressure can build up.
    [[nodiscard]] std::array<double, 3> hydrostatic(double t) const;
    [[nodiscard]] bool depends_on_position() const { return depends_on_position_; }

    /// Adds dt g to the velocities of the fluid, along the axes on which g depends on position. Returns the force on
    /// all fluid along them. All ranks take part.
    Momentum kick_fluid(ParticleStore& particles, const Ranks& ranks, double t, double dt) const;

    /// Adds m g to the forces on particles that were fluid and have turned solid. Returns the force along the axes on
    /// which g depends on position; along the others it counts as the fluid's. All ranks take part.
    Momentum add_to_solidified(ParticleStore& particles, const Ranks& ranks, double t) const;

  private:
    /// A coordinate as formulas have it: inside the periodic box, and on this side of a plane of symmetry.
    [[nodiscard]] double in_box(double x, int axis) const;

    std::array<Expression, 3> acceleration_;
    bool depends_on_position_;
    const ParticleSpace& space_;
};

}  // namespace dmp::solver
