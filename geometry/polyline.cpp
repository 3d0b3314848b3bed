// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/geometry.hpp"
#include "geometry/segments.hpp"

namespace dmp::geometry {

double Polyline::length() const {
    double sum = 0;
    for_each_segment(*this, [&](const Vec& a, const Vec& b) { sum += (b - a).norm(); });
    return sum;
}

std::pair<Vec, Vec> Polyline::at(double s) const {
    const double whole = length();
    const double slack = 1e-12 * whole;  // of the caller's own sum of segment lengths
    if (!(s >= -slack && s <= whole + slack)) throw std::out_of_range("Polyline::at: arc length outside [0, length()]");
    if (whole == 0) throw std::out_of_range("Polyline::at: a polyline without length has no tangent");

    double left = std::max(s, 0.0);
    bool found = false;
    std::pair<Vec, Vec> result;
    for_each_segment(*this, [&](const Vec& a, const Vec& b) {
        const double length = (b - a).norm();
        if (found || length == 0) return;
        const Vec tangent = (b - a) / length;
        found = left <= length;
        // Kept from every segment, so that s = length() ends exactly on the last point.
        result = {left < length ? Vec(a + left * tangent) : b, tangent};
        left -= length;
    });
    return result;
}

double CurveSet::length() const {
    double sum = 0;
    for (const auto& piece : pieces) sum += piece.length();
    return sum;
}

Projection CurveSet::nearest(const Vec& point) const {
    Projection best{.point = Vec::Constant(std::numeric_limits<double>::quiet_NaN()),
                    .distance = std::numeric_limits<double>::infinity()};
    for (const auto& piece : pieces) {
        if (piece.points.size() == 1) keep_nearest(best, point, piece.points[0], piece.points[0]);
        for_each_segment(piece, [&](const Vec& a, const Vec& b) { keep_nearest(best, point, a, b); });
    }
    return best;
}

}  // namespace dmp::geometry
