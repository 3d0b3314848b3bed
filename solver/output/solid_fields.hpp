// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solver/output/mean_displacement.hpp"
#include "solver/output/surface_traction.hpp"
#include "solver/results/frame.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What the fields of solids are of.
struct SolidState {
    const SpringBodies& springs;
    const MeanDisplacement* mean_displacement;  ///< needed for mean_displacement, else null
    const SurfaceTraction* traction;            ///< needed for traction, else null
};

/// Adds bonds and the fields of output.solid_fields that the bodies know to a group of all spring particles, in the
/// order of ids (docs/results.md):
///   displacement, mean_displacement   from where it was drawn [m]
///   stress     sigma = -W / (J V) [Pa], W the particle's share of the virial (SpringBody::virial), V its volume in the
///   SPH
///              sums and J its volume over that at rest, 1 for springs: Cauchy's stress of cells; tension is positive
///   von_mises  of that stress, nothing acting across the plane [Pa]
///   principal_stretches  least and largest of a cell, at its centroid; of springs those of the node's bonds [-]
///   surface_stress  the largest von_mises at the corners of a cell's solid; of springs von_mises [Pa]
///   traction   of the fluid on the surface (SurfaceTraction) [Pa]; 0 of particles that have none
///   strain, force   of each bond: (r - r0) / r0 [-], 2 k_b (r - r0) [N]
/// `volume` is that of the group's particles [m^3].
void add_solid_fields(FrameGroup& group, const std::vector<SolidField>& wanted, const std::vector<float>& volume,
                      const SolidState& state);

}  // namespace dmp::solver
