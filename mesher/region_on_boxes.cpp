// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/region_on_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dmp::mesher {

namespace {

/// Points along a face that are asked whether they are inside.
constexpr int points_of_a_face = 8;

CurveSet edge_of(const Region& region) {
    CurveSet edge{region.name, region.loops};
    for (Polyline& loop : edge.pieces) loop.closed = true;
    return edge;
}

/// The part of a polygon with sign (x_axis - limit) <= 0.
std::vector<Vec> clipped(const std::vector<Vec>& polygon, int axis, double limit, double sign) {
    std::vector<Vec> kept;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Vec &from = polygon[n], &to = polygon[(n + 1) % polygon.size()];
        const double start = sign * (from[axis] - limit), end = sign * (to[axis] - limit);
        if (start <= 0) kept.push_back(from);
        if ((start < 0 && end > 0) || (start > 0 && end < 0)) {
            Vec crossing = from + start / (start - end) * (to - from);
            crossing[axis] = limit;
            kept.push_back(crossing);
        }
    }
    return kept;
}

/// Integrals over an area, from its edge (Green's theorem).
struct Integrals {
    double area = 0;
    Vec first = Vec::Zero(), second = Vec::Zero();  ///< of x_i and of x_i^2

    void add(const std::vector<Vec>& polygon) {
        for (std::size_t n = 0; n < polygon.size(); ++n) {
            const Vec &a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
            const double cross = a[0] * b[1] - a[1] * b[0];
            area += cross / 2;
            first += cross / 6 * (a + b);
            second += cross / 12 * (a.cwiseAbs2() + a.cwiseProduct(b) + b.cwiseAbs2());
        }
    }
};

}  // namespace

RegionOnBoxes::RegionOnBoxes(const Region& region, const BoxLattice& lattice)
    : region_(region), lattice_(lattice), inside_(region), edge_(edge_of(region), 0.51 * lattice.step.norm()) {}

Filling RegionOnBoxes::filling(const std::array<int, 3>& box) const {
    const Vec middle = lattice_.middle(box), half = 0.5 * lattice_.step;
    if (!edge_.nearest(middle)) {
        if (inside_.side_of(middle) != Side::inside) return {};
        return {lattice_.volume(), middle, lattice_.step.cwiseAbs2() / 12};
    }
    Integrals sum;
    for (const Polyline& loop : region_.loops) {
        std::vector<Vec> polygon;
        polygon.reserve(loop.points.size());
        for (const Vec& point : loop.points) polygon.emplace_back(point - middle);
        for (int axis = 0; axis < 2; ++axis)
            for (const double sign : {1.0, -1.0}) polygon = clipped(polygon, axis, sign * half[axis], sign);
        sum.add(polygon);
    }
    // Of what rounding leaves of an area outside there is no centroid.
    if (!(sum.area > 1e-9 * lattice_.volume())) return {};
    const Vec centroid = sum.first / sum.area;
    const Vec moment = (sum.second / sum.area - centroid.cwiseAbs2()).cwiseMax(0.0);
    return {sum.area, middle + centroid, moment};
}

bool RegionOnBoxes::joined(const std::array<int, 3>& box, int axis) const {
    std::array<int, 3> next = box;
    ++next[axis];
    const std::array<int, 3> image = lattice_.in_period(next);
    const bool is_beyond = image != next;
    Vec along = Vec::Zero(), a_little = Vec::Zero();
    along[1 - axis] = lattice_.step[1 - axis];
    a_little[axis] = 1e-6 * lattice_.step[axis];
    for (int n = 0; n < points_of_a_face; ++n) {
        const Vec place = (n + 0.5) / points_of_a_face * along;
        const auto is_inside = [&](const Vec& point) { return inside_.side_of(point) == Side::inside; };
        // A periodic side is an edge of the area: what counts lies before and behind it.
        if (is_beyond ? is_inside(lattice_.corner(next) + place - a_little) &&
                            is_inside(lattice_.corner(image) + place + a_little)
                      : is_inside(lattice_.corner(next) + place))
            return true;
    }
    return false;
}

std::array<std::array<int, 3>, 2> RegionOnBoxes::boxes() const {
    Vec low = Vec::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Polyline& loop : region_.loops)
        for (const Vec& point : loop.points) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    std::array<std::array<int, 3>, 2> range{{{0, 0, 0}, {0, 0, 1}}};
    for (int axis = 0; axis < 2; ++axis) {
        const auto place = [&](double x) { return (x - lattice_.origin[axis]) / lattice_.step[axis]; };
        range[0][axis] = std::max(lattice_.first[axis], static_cast<int>(std::floor(place(low[axis]) + 1e-9)));
        range[1][axis] = std::min(lattice_.last[axis], static_cast<int>(std::ceil(place(high[axis]) - 1e-9)));
    }
    return range;
}

SolidCells RegionOnBoxes::cells() const {
    const auto [first, last] = boxes();
    return solid_cells(lattice_, first, last,
                       {[this](const auto& box) { return filling(box); },
                        [this](const auto& box, int axis) { return joined(box, axis); }});
}

}  // namespace dmp::mesher
