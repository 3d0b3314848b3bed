// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/exact_predicates.hpp"

#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace dmp::geometry {

int side_of_line(const Vec& a, const Vec& b, const Vec& p) {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
    return static_cast<int>(CGAL::orientation(Point(a.x(), a.y()), Point(b.x(), b.y()), Point(p.x(), p.y())));
}

RayMeeting meet_ray(const Vec& point, const Vec& a, const Vec& b) {
    const Vec& low = a.y() <= b.y() ? a : b;
    const Vec& high = a.y() <= b.y() ? b : a;
    const auto [left, right] = std::minmax(a.x(), b.x());
    // Comparing doubles is exact; only points inside the segment's box need the determinant.
    const bool near = point.y() >= low.y() && point.y() <= high.y() && point.x() <= right;
    if (!near) return RayMeeting::misses;  // nor does what is no number meet anything
    const bool spans = low.y() <= point.y() && point.y() < high.y();
    if (point.x() < left) return spans ? RayMeeting::crosses : RayMeeting::misses;
    const int side = side_of_line(low, high, point);
    if (side == 0) return RayMeeting::starts_on;
    return spans && side > 0 ? RayMeeting::crosses : RayMeeting::misses;
}

bool segments_cross(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
    return side_of_line(a, b, c) * side_of_line(a, b, d) < 0 && side_of_line(c, d, a) * side_of_line(c, d, b) < 0;
}

}  // namespace dmp::geometry
