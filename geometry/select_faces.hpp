// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// Adds a surface set for each selection, in 2-D a curve set, in their order; later ones may be of earlier ones.
/// A triangle or a straight piece of a curve lies in a plane or box to within 1e-5 of the size of what it belongs to:
/// surfaces stored with seven digits still do. Throws InputError: a selection of something that the geometry has not,
/// one of nothing, one whose name is taken.
void select_faces(Geometry& geometry, const std::vector<FaceSelection>& selections);

}  // namespace dmp::geometry
