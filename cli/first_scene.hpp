// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::cli {

/// A scene for a drawing of which nothing is known but its shapes.
struct FirstScene {
    std::string text;                      ///< TOML
    std::vector<std::string> assumptions;  ///< for a person, the same as the scene's comments
};

/// Water (blood, air, where the name says so) in the body that looks like the fluid, everything else a wall at rest; 20
/// particles across the fluid's smallest extent, fewer where that would be more than 200,000. Where the fluid's two
/// ends along its longest axis are flat and alike, the axis is periodic and the fluid is driven along it, at a Reynolds
/// number of 10 about; a round one starts from Poiseuille's profile. Otherwise the fluid is enclosed and at rest.
/// `unit_given`: the scene states the drawing's unit. Throws InputError: a drawing in the plane, or one without a
/// solid.
FirstScene first_scene(const Geometry& geometry, bool unit_given);

}  // namespace dmp::cli
