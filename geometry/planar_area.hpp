// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/cad_curves.hpp"

namespace dmp::geometry {

/// The area that some surfaces of the geometry that gmsh has open make up. Throws InputError: it is empty, open,
/// crosses itself or has no area.
Region planar_area(const std::string& name, const std::vector<int>& surfaces, CadCurves& curves,
                   const std::string& file);

/// Sets the box of a geometry in 2-D, and puts it on z = 0 where rounding left it beside. Throws InputError: it
/// leaves the plane, or has a point that is not finite.
void lay_flat(Geometry& geometry);

}  // namespace dmp::geometry
