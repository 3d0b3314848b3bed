// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/standing_strips.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::geometry {

TriangleSurface standing_strips(const std::vector<PlaneSegment>& segments, double height) {
    TriangleSurface strips;
    const Vec up(0, 0, height);
    for (const auto& [start, end] : segments) {
        const int parts = static_cast<int>(std::clamp(std::ceil((end - start).norm() / height), 1.0, 1000.0));
        const Vec along = (end - start) / parts;
        for (int k = 0; k < parts; ++k) {
            const auto first = static_cast<int>(strips.corners.size());
            const Vec from = start + k * along, to = from + along;
            for (const Vec& corner : {from, to, Vec(to + up), Vec(from + up)}) strips.corners.push_back(corner);
            strips.triangles.push_back({first, first + 1, first + 2});
            strips.triangles.push_back({first, first + 2, first + 3});
        }
    }
    return strips;
}

}  // namespace dmp::geometry
