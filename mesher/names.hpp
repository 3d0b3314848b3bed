// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// Checks that each part finds its region or curve, each anchor its points, and that every name in the geometry is
/// used. Throws InputError with the scene's place and the nearest right name.
void check_names(const Geometry& geometry, const Scene& scene);

/// Checks that the fluid's boundary is closed by rigid parts, other fluids or periodic sides, and that periodic sides
/// match each other. `box` is the fluid's. Throws InputError with the place of the opening.
void check_boundary(const Geometry& geometry, const Scene& scene, const Box& box);

/// The error of a fluid whose border, there, is a strip or a shell with nothing behind it.
InputError sheet_as_border(const Part& fluid, const Part& sheet, const Vec& where, int dimension);

}  // namespace dmp::mesher
