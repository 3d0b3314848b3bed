// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// Calls visit(a, b) for each segment in order, the closing one last where the line is closed.
template <class Visit>
void for_each_segment(const Polyline& line, Visit&& visit) {
    const auto& points = line.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) visit(points[i], points[i + 1]);
    if (line.closed && points.size() > 1) visit(points.back(), points.front());
}

/// Calls visit(a, b) for each boundary segment of a region; its loops count as closed whatever their flag says.
template <class Visit>
void for_each_segment(const Region& region, Visit&& visit) {
    for (const auto& loop : region.loops) {
        const auto& points = loop.points;
        for (std::size_t i = 0; i < points.size(); ++i) visit(points[i], points[i + 1 == points.size() ? 0 : i + 1]);
    }
}

/// The point of segment a-b nearest to `point`.
inline Projection nearest_on_segment(const Vec& point, const Vec& a, const Vec& b) {
    const Vec along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0 ? std::clamp((point - a).dot(along) / square, 0.0, 1.0) : 0.0;
    const Vec foot = t == 1.0 ? b : Vec(a + t * along);
    return {.point = foot, .distance = (point - foot).norm()};
}

/// Replaces `best` by the point of segment a-b nearest to `point` where that is strictly nearer.
inline void keep_nearest(Projection& best, const Vec& point, const Vec& a, const Vec& b) {
    const Projection here = nearest_on_segment(point, a, b);
    if (here.distance < best.distance) best = here;
}

}  // namespace dmp::geometry
