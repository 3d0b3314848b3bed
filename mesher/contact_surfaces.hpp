// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/body_surfaces.hpp"

namespace dmp::mesher {

/// Contact looks no farther into a solid than this [spacings].
inline constexpr double farthest_behind = 3;

/// Draws the surfaces that touch, where the scene wants surfaces to. In 3-D as triangles (contact_triangles.hpp), in
/// 2-D in pieces of at most a spacing: outlines of elastic areas without what lies on periodic sides and planes of
/// symmetry; of strips both sides, half their thickness from the middle, and the ends; of walls the sides on which
/// liquid or an elastic body may be. Corners stay; points nearer than half a spacing to the one before are left out
/// where the curve goes on smoothly. `strips`: the elastic parts that are sheets.
void draw_contact_surfaces(const Geometry& geometry, const Scene& scene, const std::vector<Sheet>& strips,
                           ParticleSet& set);

}  // namespace dmp::mesher
