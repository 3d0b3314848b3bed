// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Smallest distance between centres of particles of different pieces of an elastic solid. A piece is what the part's
/// own bonds hold together as drawn, and what it broke into; bonds of a [[join]] make one body of pieces, but not one
/// piece.
class GapMeasure {
  public:
    /// Throws InputError for a part of one piece.
    GapMeasure(const Measure& measure, const ParticleSet& set);

    /// [m]; infinite once there is but one piece.
    [[nodiscard]] double smallest(const SpringBodies& springs) const;

  private:
    ParticleSpace space_;
    std::unordered_map<int, int> piece_;  ///< by particle
};

}  // namespace dmp::solver
