// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// The smallest box around a surface's corners; of none from infinity to -infinity.
inline Box box_of(const TriangleSurface& surface) {
    Box box{.low = Vec::Constant(std::numeric_limits<double>::infinity()), .high = {}};
    box.high = -box.low;
    for (const Vec& corner : surface.corners) {
        box.low = box.low.cwiseMin(corner);
        box.high = box.high.cwiseMax(corner);
    }
    return box;
}

}  // namespace dmp::geometry
