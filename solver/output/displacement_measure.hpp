// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_set>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Displacement of an elastic solid from its initial position: of its centre of mass,
///   SUM m u / SUM m   [m],
/// or of the particle that was initially nearest to a point. Every rank has all of it, as it has all bodies.
class DisplacementMeasure {
  public:
    /// `set` as at the start of the run. Throws InputError where the point is not in the solid.
    DisplacementMeasure(const Measure& measure, const ParticleSet& set);

    /// [m]
    [[nodiscard]] Vec mean(const SpringBodies& springs) const;

  private:
    std::unordered_set<int> particles_;  ///< ids
};

}  // namespace dmp::solver
