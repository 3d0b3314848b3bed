// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Adds up how long each fluid particle has been in each of the scene's regions [s]: a step counts with its whole
/// length when the particle is inside at its end, so a crossing is right within one step. The sums travel with the
/// particles. Without residence_time among the fields asked for nothing is allocated or done.
class ResidenceTimes {
  public:
    /// Declares the field where it is wanted.
    ResidenceTimes(const Scene& scene, ParticleStore& particles);

    /// After a step of dt [s].
    void add(ParticleStore& particles, double dt, int threads) const;

  private:
    std::vector<ResidenceRegion> regions_;  ///< empty: not wanted
};

}  // namespace dmp::solver
