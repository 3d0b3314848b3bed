// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/parallel/resources.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Wall time measured on the scene's own particles [ns per particle and step].
struct MeasuredTime {
    std::string of;     ///< a stage of the step, or a model
    double ns = 0;      ///< of the fastest round: whatever else the machine does only adds to it
    double spread = 0;  ///< how much longer the third fastest took
};

/// The time on the wall clock, from any origin [s].
double wall_time();

struct ModelCosts {
    MeasuredTime step;                 ///< all of it
    std::vector<MeasuredTime> stages;  ///< of which, in its fastest round
    /// Of each model that can be left out: the scene with it less the scene without it, both run in turns.
    std::vector<MeasuredTime> models;
    long steps = 0;   ///< of the whole scene that were timed
    int threads = 1;  ///< that they ran on
};

/// Runs the scene's first steps, and those of the scene without each model that it could do without, for about this
/// long [s] by the clock; less is measured where the particles are too many for that. Nothing is written.
ModelCosts measure_costs(const Scene& scene, const ParticleSet& particles, const Resources& resources, double seconds,
                         const std::function<double()>& clock = wall_time);

}  // namespace dmp::solver
