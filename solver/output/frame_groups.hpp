// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/output/mean_displacement.hpp"
#include "solver/results/frame.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// This rank's particles of those whose part is chosen, at the places where they are shown: within the periodic box,
/// and on the fluid's side of planes of symmetry.
FrameGroup group_of(const std::string& name, const ParticleGroup& particles, const ParticleSpace& space,
                    const std::function<bool(int)>& chosen = {});

/// Replaces the group by the particles of all ranks on the first one, in the order of their ids; empty on the others.
void collect(FrameGroup& group, const Ranks& ranks);

/// The particles of all elastic solids as a frame shows them.
struct SolidGroup {
    FrameGroup group;           ///< called "solid"
    std::vector<float> volume;  ///< of its particles in the SPH sums [m^3]
};

/// The elastic solids with their bonds and these fields, in the order of ids, on the first rank; empty on the others.
/// All ranks together. `mean_displacement` may be null unless its field is asked for.
SolidGroup solid_group(const ParticleStore& particles, const FluidStep& step, const std::vector<SolidField>& fields,
                       const MeanDisplacement* mean_displacement);

}  // namespace dmp::solver
