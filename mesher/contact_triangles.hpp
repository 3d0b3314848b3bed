// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesher/body_surfaces.hpp"

namespace dmp::mesher {

/// Draws the surfaces that touch in 3-D, in triangles with edges of about 3/4 of a spacing, a spacing at most
/// (geometry/even_triangles.hpp), that face out of the solid behind them: of elastic volumes their surface, without
/// what lies on periodic sides and planes of symmetry; of sheets both sides, half the distance between them from the
/// middle, and the rim; of walls the sides on which liquid or an elastic body may be. Triangles that touch in a corner
/// have one point there, but for the two sides of a wall. How thick the solid behind a triangle is, is where a line
/// against its normal leaves the solid, three spacings at most; 0 for a wall that may be touched from both sides.
void draw_contact_triangles(const Geometry& geometry, const Scene& scene, const std::vector<Sheet>& sheets,
                            ParticleSet& set);

}  // namespace dmp::mesher
