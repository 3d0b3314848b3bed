// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/uses.hpp"
#include "geometry/geometry.hpp"
#include "scene/scene.hpp"

namespace dmp::cli {

/// Whether the parts of a geometry have a size that goes with the scene's spacing; where they have not, their unit is
/// mostly wrong. Throws InputError: a solid or region that is smaller than a particle, or so large that no machine
/// holds the lattice around it; ResourceError where this machine does not. Notes on stderr a lattice that takes minutes
/// to fill.
void check_geometry_size(const Geometry& geometry, const Scene& scene);

}  // namespace dmp::cli
