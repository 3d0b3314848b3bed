// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/repair_surface.hpp"

namespace dmp::geometry {

/// Makes solids of the surface sets with these names, with repair_surface: what a file of triangles was to be, but is
/// not closed. Names of what is a solid already, or is not in the geometry, are passed over. Returns what the reports
/// say, a line each, beginning with the name. Throws UnusableSurface, which names the geometry.
std::vector<std::string> repair_solids(Geometry& geometry, const std::vector<std::string>& names,
                                       const RepairLimits& limits);

}  // namespace dmp::geometry
