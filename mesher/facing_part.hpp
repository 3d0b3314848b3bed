// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "geometry/triangle_surface.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// The part of a surface for whose places `counts(place, normal)` holds: whole triangles where it does all over, else
/// pieces of them. It is looked at in places about `distance` [m] apart, and cut to within a quarter of that; no piece
/// reaches further. Triangles share no corners in it. `counts` is asked by several threads at once.
[[nodiscard]] TriangleSurface facing_part(const TriangleSurface& surface, double distance,
                                          const std::function<bool(const Vec& position, const Vec& normal)>& counts);

}  // namespace dmp::mesher
