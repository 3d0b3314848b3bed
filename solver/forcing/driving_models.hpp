// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Adds what pushes from outside, fluid or spheres: body acceleration, pressure gradient, forces on parts, moving
/// shapes.
void add_driving_models(std::vector<ModelUse>& models, const Scene& scene);

}  // namespace dmp::solver
