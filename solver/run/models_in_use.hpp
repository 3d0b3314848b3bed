// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/results/plan.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

class SurfaceContact;

/// Which models a scene of fluids, walls and springs runs, their sources, and what in it asks for them.
std::vector<ModelUse> models_in_use(const Scene& scene, const PairSettings& settings, const PairSweeps& sweeps,
                                    const SpringBodies& springs, const SurfaceContact* contact);

}  // namespace dmp::solver
