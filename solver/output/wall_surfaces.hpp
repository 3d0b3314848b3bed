// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "particles/particle_set.hpp"
#include "solver/results/frame.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The walls for spheres whose part is chosen, as triangles to look at: surfaces as they are, of a plane the piece that
/// crosses `shown`. `displacement` tells how far a part has moved [m]. Without such walls the group is empty.
FrameGroup wall_surfaces(const std::string& name, const ParticleSpace& space, const Box& shown,
                         const std::function<bool(int)>& chosen, const std::function<Vec(int)>& displacement);

}  // namespace dmp::solver
