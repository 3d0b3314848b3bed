// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/turned_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include "mesher/cell_solids.hpp"
#include "mesher/own_lattice.hpp"

namespace dmp::mesher {

namespace {

constexpr double same_direction = 1e-6;  ///< [rad]
/// Of an area's edge.
constexpr double straight_share = 0.8;

std::vector<Vec> edges_of(const Region& region) {
    std::vector<Vec> edges;
    for (const Polyline& loop : region.loops)
        for (std::size_t n = 0; n < loop.points.size(); ++n)
            edges.emplace_back(loop.points[(n + 1) % loop.points.size()] - loop.points[n]);
    return edges;
}

/// Modulo a quarter turn, so that directions across each other are one [rad].
double quarter(double angle) { return std::remainder(angle, std::numbers::pi / 2); }

bool reaches_a_held_side(const ParticleSpace& space, const Box& extent) {
    const double a_little = 1e-6 * space.spacing;
    for (int axis = 0; axis < space.dimension; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const bool low = space.periodic.at(at) || space.mirrored.at(at)[0],
                   high = space.periodic.at(at) || space.mirrored.at(at)[1];
        if (low && extent.low[axis] <= space.box.low[axis] + a_little) return true;
        if (high && extent.high[axis] >= space.box.high[axis] - a_little) return true;
    }
    return false;
}

bool has_anchor(const LatticeMarks& marks) { return marks.anchor[0] || marks.anchor[1]; }

}  // namespace

Turn::Turn(double angle) : cosine_(std::cos(angle)), sine_(std::sin(angle)) {}

Vec Turn::of(const Vec& point) const {
    if (is_none()) return point;
    return {cosine_ * point[0] + sine_ * point[1], cosine_ * point[1] - sine_ * point[0], point[2]};
}
Vec Turn::back(const Vec& point) const {
    if (is_none()) return point;
    return {cosine_ * point[0] - sine_ * point[1], cosine_ * point[1] + sine_ * point[0], point[2]};
}
Region Turn::of(Region region) const {
    for (Polyline& loop : region.loops)
        for (Vec& point : loop.points) point = of(point);
    return region;
}
CurveSet Turn::of(CurveSet curves) const {
    for (Polyline& piece : curves.pieces)
        for (Vec& point : piece.points) point = of(point);
    return curves;
}

double direction_of(const Region& region, double spacing) {
    const std::vector<Vec> edges = edges_of(region);
    double all = 0, most = 0, best = 0;
    for (const Vec& edge : edges) all += edge.norm();
    for (const Vec& side : edges) {
        if (side.norm() < spacing) continue;
        const double angle = quarter(std::atan2(side[1], side[0]));
        double along = 0;
        for (const Vec& edge : edges)
            if (std::abs(quarter(std::atan2(edge[1], edge[0]) - angle)) <= same_direction) along += edge.norm();
        if (along <= (1 + 1e-9) * most) continue;
        most = along;
        best = angle;
    }
    return most >= straight_share * all && std::abs(best) > same_direction ? best : 0;
}

LatticeInPlane lattice_in_plane(const ParticleSpace& space, const Vec& step, const Region& region,
                                const CurveSet* anchor) {
    const BoxLattice of_scene = boxes_of(space, step);
    const LatticeMarks marks = marks_of(region, anchor, space.spacing);
    const double angle = direction_of(region, space.spacing);
    if (angle != 0 && !reaches_a_held_side(space, marks.extent)) {
        const Turn turn(angle);
        const CurveSet held = anchor != nullptr ? turn.of(*anchor) : CurveSet{};
        const LatticeMarks turned = marks_of(turn.of(region), anchor != nullptr ? &held : nullptr, space.spacing);
        if (anchor == nullptr || has_anchor(turned) || !has_anchor(marks)) {
            ParticleSpace open;
            open.spacing = space.spacing;
            open.box = turned.extent;
            const double even = std::sqrt(step[0] * step[1]);
            std::ostringstream text;
            text.precision(4);
            text << "turned by " << angle * 180 / std::numbers::pi << " degrees, along its sides";
            return {turn, own_lattice(open, boxes_of(open, Vec(even, even, 0)), turned), text.str()};
        }
    }
    BoxLattice own = own_lattice(space, of_scene, marks);
    std::string text = lattice_text(of_scene, own);
    return {Turn(), std::move(own), std::move(text)};
}

}  // namespace dmp::mesher
