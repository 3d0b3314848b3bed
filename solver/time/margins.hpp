// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Adds to the plan the margins of the keys that set its steps (scene::step_margins), and warns of those that the scene
/// gives with less than scene::least_margin. Where another of the plan's limits keeps the steps shorter than the key
/// does, at all times of the run, the margin is as much larger. `plan`: its limits are those of the steps alone.
void add_margins(Plan& plan, const Scene& scene);

}  // namespace dmp::solver
