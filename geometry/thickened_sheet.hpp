// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A connected sheet as a body that faces outward: a copy of it half a thickness [m] to either side, along the corners'
/// mean normals, and a strip between the copies along its border, but for the edges that are `held`, of which it gets
/// the ends.
TriangleSurface thickened_sheet(TriangleSurface sheet, double thickness,
                                const std::function<bool(const Vec&, const Vec&)>& held);

}  // namespace dmp::geometry
