// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/results/frame.hpp"
#include "solver/spheres/sphere_step.hpp"

namespace dmp::solver {

/// What the spheres look like now: a group "spheres" with radius, velocity, angular_velocity and contact_force, in the
/// order of their ids, and their walls: "walls" where they are asked for, "moving_walls" always. All ranks take part;
/// in pieces every rank gets its own spheres, and the first one the walls; else the first one gets all.
Frame sphere_frame(const SphereStep& step, const ParticleSpace& space, double time, long step_count, bool with_walls,
                   bool in_pieces);

}  // namespace dmp::solver
