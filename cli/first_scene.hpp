// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "geometry/geometry.hpp"

namespace dmp::cli {

/// A scene for a geometry of which nothing is known but its shapes.
struct FirstScene {
    std::string text;                      ///< TOML
    std::vector<std::string> assumptions;  ///< for a person, the same as the scene's comments
};

/// Water (blood, air, where the name says so) in the body that looks like the fluid, everything else a wall at rest; 20
/// particles across the fluid's smallest extent, fewer where that would be more than 200,000. Where the fluid's two
/// ends along its longest axis are flat and alike, the axis is periodic and the fluid is driven along it, at a Reynolds
/// number of 10 about; a round one starts from Poiseuille's profile. Otherwise the fluid is enclosed and at rest.
/// `unit_given`: the scene states the geometry's unit. Of a geometry in 2-D: first_scene_in_plane. Throws
/// InputError: a geometry without a solid, or in 2-D without an area.
FirstScene first_scene(const Geometry& geometry, bool unit_given);

/// The same of a geometry in 2-D, all of whose areas are one fluid. Named curves at its edge are walls at rest,
/// and so is what of the edge has no name; curves that lie in the fluid are flexible, clamped where they meet a wall,
/// and so stiff that what drives the fluid bends them by a tenth of their length. Sides of the box that face each
/// other, are alike and without a wall are periodic, or the two ends along the longest axis where they have names of
/// their own or nothing at the edge has one. Particles: 20 across the usual distance between walls, 6 across the
/// narrowest gap at the tip of a flexible curve, 8 along one.
FirstScene first_scene_in_plane(const Geometry& geometry, bool unit_given);

}  // namespace dmp::cli
