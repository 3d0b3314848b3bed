// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace dmp::geometry {

/// Polygons with more corners are not split: the time grows with the square of their number.
inline constexpr std::size_t most_polygon_corners = 4096;

/// Splits a polygon, flat or nearly so, into triangles of its own corners that turn as it does, by cutting off ears
/// (Meisters 1975), seen along its mean normal (Newell's). Of one that crosses itself the triangles are some that
/// bound the same curve. Time grows with the square of its corners, at most.
std::vector<std::array<std::size_t, 3>> split_polygon(std::span<const Vec> corners);

}  // namespace dmp::geometry
