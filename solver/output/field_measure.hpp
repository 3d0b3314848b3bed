// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Mean, lowest and highest value of the measure's field, vectors by their magnitude, and the coordinates of the
/// highest; NaN where there are no particles. All ranks together, with the same bits for any number of them.
///
/// Of the fluid in the measure's region, or of all of it; the mean is weighted by volume.
std::vector<double> range_in_fluid(const Scene& scene, const Measure& measure, const ParticleStore& particles,
                                   const FluidStep& step);
/// Of the measure's elastic part: fields of particles with their mean by volume, those of bonds by number, at their
/// middles; tractions of those that have one.
std::vector<double> range_in_solid(const Measure& measure, const ParticleStore& particles, const FluidStep& step);

}  // namespace dmp::solver
