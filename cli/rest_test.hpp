// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/uses.hpp"
#include "mesher/mesh.hpp"

namespace dmp::cli {

inline constexpr long steps_at_rest = 500;

/// Runs the particles for at least about `steps` steps of the scene's own length with all that drives them switched
/// off: body forces, motions of walls and their surfaces, the fluid's velocity and pressure at the start, [[force]],
/// [[moving_shape]],
/// [[solidify]] and [[break]]. Sound, kernel and walls stay the scene's. Not for scenes of spheres.
[[nodiscard]] MeshReport::RestLine rest_test(const Scene& scene, const ParticleSet& particles,
                                             long steps = steps_at_rest);

}  // namespace dmp::cli
