// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace dmp::particles {

/// Coordinates of many points, one array an axis; unused axes are empty in the third entry of a 2-D set.
using Coordinates = std::array<std::vector<double>, 3>;

/// A copy of a particle, moved by whole periods.
struct PeriodicImage {
    int source = 0;
    std::array<double, 3> shift{};  ///< image position = source position + shift [m]
};

/// Every image (corners included) that lies within `reach` of the box; points must lie in the box along periodic axes,
/// whose periods must be positive.
/// Ordered by axis of creation and then by source, so the order depends on positions alone.
std::vector<PeriodicImage> periodic_images(const Coordinates& points, std::size_t count, const Box& box,
                                           const std::array<bool, 3>& periodic, double reach);

/// `x` moved by whole periods into [low, high), unchanged where it lies there already.
double wrapped(double x, double low, double high);

}  // namespace dmp::particles
