// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/open_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dmp::mesher {

bool on_open_side(std::span<const Vec> points, const ParticleSpace& space) {
    for (int axis = 0; axis < space.dimension; ++axis)
        for (const std::size_t side : {0U, 1U}) {
            const auto across = static_cast<std::size_t>(axis);
            if (!space.periodic.at(across) && !space.mirrored.at(across).at(side)) continue;
            const double at = (side == 0 ? space.box.low : space.box.high)[axis];
            if (std::ranges::all_of(points,
                                    [&](const Vec& p) { return std::abs(p[axis] - at) < 1e-6 * space.spacing; }))
                return true;
        }
    return false;
}

TriangleSurface without_open_sides(TriangleSurface surface, const ParticleSpace& space) {
    std::erase_if(surface.triangles, [&](const std::array<int, 3>& triangle) {
        std::array<Vec, 3> corners;
        std::ranges::transform(triangle, corners.begin(),
                               [&](int corner) { return surface.corners[static_cast<std::size_t>(corner)]; });
        return on_open_side(corners, space);
    });
    return surface;
}

}  // namespace dmp::mesher
