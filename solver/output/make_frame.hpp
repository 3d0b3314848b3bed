// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solver/frame.hpp"
#include "solver/time/fluid_step.hpp"

namespace dmp {

/// What the particles look like now: fluid with the scene's output fields; solids with velocity, displacement from
/// the drawing, bond strain and bond force; walls when asked for. All ranks take part; the first one gets the frame,
/// the others an empty one.
Frame make_frame(const Scene& scene, const ParticleStore& particles, const FluidStep& fluid, double time, long step,
                 bool with_walls);

}  // namespace dmp
