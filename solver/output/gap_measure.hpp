// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Smallest distance between different pieces of an elastic solid: of their surfaces, below 0 where they are pressed
/// into each other; of their middles between both sides; or of the centres of their particles. A surface or a middle is
/// one flat patch in front of each particle, as wide as the particle. A piece is what the part's own bonds hold
/// together as drawn, and what it broke into; bonds of a [[join]] make one body of pieces, but not one piece.
class GapMeasure {
  public:
    /// Throws InputError for a part of one piece.
    GapMeasure(const Measure& measure, const ParticleSet& set);

    /// [m]; infinite once there is but one piece.
    [[nodiscard]] double smallest(const SpringBodies& springs) const;

  private:
    /// Where a particle's surface, its middle or the particle itself is.
    struct Patch {
        std::pair<std::size_t, int> piece;  ///< body now, and piece as drawn
        Vec centre;
        Vec normal;           ///< 0: a point
        double radius;        ///< of what is round about a point [m]
        double half_through;  ///< half of the solid's thickness there, 0 for middles [m]
    };
    [[nodiscard]] Patch patch_of(const Vec& position, const SolidSurface& surface) const;
    /// From the centre of one patch to another.
    [[nodiscard]] double distance(const Patch& from, const Patch& to) const;

    ParticleSpace space_;
    GapBetween between_;
    std::unordered_map<int, int> piece_;  ///< by particle
};

}  // namespace dmp::solver
