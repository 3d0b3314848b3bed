// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Whether an elastic solid has an initial_velocity.
bool elastic_solids_start_moving(const Scene& scene);

/// Whether anything moves fluid or solids, or may: a formula that is not 0, a force, a moving shape or wall, a pressure
/// at the start.
bool is_driven(const Scene& scene);

/// Whether species diffuse, stepped explicitly, in a fluid at rest: nothing drives the scene, and nothing in it is
/// elastic or turns solid. Implicit diffusion needs the flow's step for its accuracy.
bool is_at_rest(const Scene& scene);

}  // namespace dmp::solver
