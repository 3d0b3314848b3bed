// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// What a scene asks of its geometry: the file, its unit where the scene gives it, parameters and selections. Curves in
/// the plane are followed to a thousandth of a spacing, surfaces in 3-D to a two-hundredth: their triangles grow with
/// the inverse of that.
[[nodiscard]] GeometryOptions geometry_options_of(const Scene& scene);

}  // namespace dmp::mesher
