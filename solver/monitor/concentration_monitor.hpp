// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/plan.hpp"
#include "solver/species/species_transport.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Watches the concentrations in the fluid. Diffusion keeps them between 0 and the largest that is given, at the start
/// or at a surface; sharp steps that move fast overshoot, and steps that are too long let them grow without end.
class ConcentrationMonitor {
  public:
    explicit ConcentrationMonitor(const Scene& scene) : scene_(scene), overshoot_(scene.species.size(), 0.0) {}

    /// A line with the problem and one with what to do, where this rank has a particle that holds more than ten times
    /// the largest amount that it can have been given, or less than minus that, or no number; else "".
    [[nodiscard]] std::string check(const ParticleStore& particles, const SpeciesTransport& species);

    /// Of species that went beyond their bounds by more than a twentieth of the largest concentration that is given,
    /// since the start or the last resumption; none of those that a surface gives a flux of. All ranks take part.
    [[nodiscard]] std::vector<Warning> warnings(const Ranks& ranks) const;

  private:
    [[nodiscard]] std::string likely_cause() const;

    const Scene& scene_;
    std::vector<double> overshoot_;  ///< by species: the largest, over the largest concentration given [-]
};

}  // namespace dmp::solver
