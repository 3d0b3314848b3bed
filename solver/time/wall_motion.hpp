// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "scene/scene.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp {

/// Rigid parts whose surface slides in itself: a lid, a belt. Their particles stay where they are. The viscous force
/// sees the surface's velocity in `velocity` of the wall's particles; the density rate sees how the particles move, so
/// that the end of a lid is no source of liquid.
/// Momentum that the fluid is given is the reaction of the walls' forces, as it is at walls at rest.
class WallMotion {
  public:
    WallMotion(const Scene& scene, const ParticleSpace& space);

    /// Puts the surfaces' velocities at time t [s] into the walls' `velocity`, of copies too. True: some differ from
    /// place to place, and copies have yet to be given those of their particles.
    [[nodiscard]] bool show_surfaces(ParticleGroup& walls, double t) const;
    /// Puts the velocities of the particles themselves there.
    void show_motion(ParticleGroup& walls) const;

  private:
    struct Surface {
        std::uint16_t part = 0;
        std::array<Expression, 3> velocity;
        bool by_place = false;  ///< it differs from place to place
    };
    std::vector<Surface> surfaces_;
};

}  // namespace dmp
