// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/uses.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

/// What a short trial showed.
struct Trial {
    long steps = 0;
    double seconds_per_step = 0;
    double peak_memory = 0;  ///< of all ranks' processes [bytes]; 0 when the system does not say
};

/// Runs the scene for about `budget` seconds of wall time without writing, and says how fast it went. All ranks
/// together.
[[nodiscard]] Trial try_out(const Scene& scene, const ParticleSet& particles, const Resources& resources, double until,
                            double budget);

/// Particles, memory, largest steps, number of steps and measured time of the run that is planned.
[[nodiscard]] std::string dry_run_text(const Scene& scene, const Plan& plan, const Trial& trial, double until);

}  // namespace dmp::cli
