// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/vec.hpp"

namespace dmp::geometry {

/// On which side of the line a -> b the point p lies in the x-y plane: +1 left, -1 right, 0 exactly on it.
/// Exact: the sign is that of real arithmetic on the given doubles.
[[nodiscard]] int side_of_line(const Vec& a, const Vec& b, const Vec& p);

/// How a ray from a point towards +x meets a segment (half-open in y, so that a ray through a vertex counts once).
enum class RayMeeting { misses, crosses, starts_on };

/// Exact, in the x-y plane; starts_on when the point lies on the closed segment a-b.
[[nodiscard]] RayMeeting meet_ray(const Vec& point, const Vec& a, const Vec& b);

/// Whether the interiors of the segments a-b and c-d cross in one point (exact; touching and overlapping do not count).
[[nodiscard]] bool segments_cross(const Vec& a, const Vec& b, const Vec& c, const Vec& d);

}  // namespace dmp::geometry
