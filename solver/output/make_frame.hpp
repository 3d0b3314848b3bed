// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solver/output/mean_displacement.hpp"
#include "solver/results/frame.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

struct FrameOptions {
    bool with_walls = false;
    /// Every rank gets the fluid and walls that it owns, the first one also all spring bodies, which are few; else the
    /// first one gets all and the others an empty frame.
    bool in_pieces = false;
};

/// What the particles look like now: fluid and solids with the scene's output fields; walls when asked for. In the
/// order of their ids. All ranks take part.
Frame make_frame(const Scene& scene, const ParticleStore& particles, const FluidStep& fluid,
                 const MeanDisplacement& mean_displacement, double time, long step, FrameOptions options);

}  // namespace dmp::solver
