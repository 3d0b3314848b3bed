// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/sphere_packing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/random_number.hpp"
#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::mesher {

namespace {

/// Spheres are pushed this much further apart than they must be, so that a few passes end what would take for ever.
constexpr double margin = 1e-3;
constexpr int most_passes = 5000;

Coordinates coordinates(const std::vector<Vec>& points) {
    Coordinates all;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const Vec& point : points) all.at(axis).push_back(point[static_cast<Eigen::Index>(axis)]);
    return all;
}

std::array<double, 3> three(const Vec& v) { return {v[0], v[1], v[2]}; }

/// From b to a, of length 1; any direction where they coincide.
Vec direction(const Vec& a, const Vec& b) {
    const Vec apart = a - b;
    return apart.norm() > 0 ? Vec(apart.normalized()) : Vec::UnitX();
}

/// Pushes points apart that are nearer than `least`, one pass after the other, until none is and `put_back`, which puts
/// a point where it may be, leaves all as they are. `put_back` returns whether the point was where it may be.
bool push_apart(std::vector<Vec>& points, double least, const std::function<bool(Vec&)>& put_back) {
    const double wanted = least * (1 + margin);
    for (int pass = 0; pass < most_passes; ++pass) {
        bool done = true;
        const CellGrid grid(coordinates(points), points.size(), 3, wanted);
        for (std::size_t i = 0; i < points.size(); ++i) {
            grid.for_each_near(three(points[i]), wanted, [&](int k) {
                const auto j = static_cast<std::size_t>(k);
                if (j <= i) return;
                const double distance = (points[i] - points[j]).norm();
                if (distance >= least) return;
                done = false;
                const Vec step = 0.5 * (wanted - distance) * direction(points[i], points[j]);
                points[i] += step;
                points[j] -= step;
            });
        }
        for (Vec& point : points) done = put_back(point) && done;
        if (done) return true;
    }
    return false;
}

/// Any turn is as likely as any other (Shoemake 1992).
Eigen::Quaterniond random_turn(std::uint64_t seed, std::uint64_t id) {
    constexpr double whole = 2 * std::numbers::pi;
    const double share = random_number({seed, id, 0}), a = whole * random_number({seed, id, 1}),
                 b = whole * random_number({seed, id, 2});
    const double one = std::sqrt(1 - share), other = std::sqrt(share);
    return {one * std::sin(a), one * std::cos(a), other * std::sin(b), other * std::cos(b)};
}

/// Points of a spiral that spreads them evenly over a sphere, each moved at random by up to half the mean distance
/// along each axis, and all turned together.
std::vector<Vec> spread(double radius, int count, std::uint64_t seed) {
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    const double reach = 0.5 * radius * std::sqrt(4 * std::numbers::pi / count);
    const Eigen::Quaterniond turn = random_turn(seed, static_cast<std::uint64_t>(count));
    std::vector<Vec> points;
    for (int n = 0; n < count; ++n) {
        const double height = 1 - (2.0 * n + 1) / count, across = std::sqrt(1 - height * height);
        Vec point = radius * Vec(across * std::cos(golden_angle * n), across * std::sin(golden_angle * n), height);
        for (int axis = 0; axis < 3; ++axis) {
            const double share = random_number({seed, static_cast<std::uint64_t>(n), static_cast<std::uint64_t>(axis)});
            point[axis] += reach * (2 * share - 1);
        }
        points.emplace_back(turn * (radius / point.norm() * point));
    }
    return points;
}

}  // namespace

double coverage_of(int count, double inner_radius, double radius) {
    const double share = radius / (2 * (inner_radius + radius));
    return count * share * share;
}

int count_for_coverage(double coverage, double inner_radius, double radius) {
    return static_cast<int>(std::lround(coverage / coverage_of(1, inner_radius, radius)));
}

std::optional<std::vector<Vec>> pack_around(const Vec& centre, double shell, double radius, int count,
                                            std::uint64_t seed) {
    if (coverage_of(count, shell - radius, radius) > 1) return std::nullopt;
    std::vector<Vec> points = spread(shell, count, seed);
    // On the sphere a step along the chord shortens as the point is put back: within the margin after some passes.
    const auto on_shell = [&](Vec& point) {
        point *= shell / point.norm();
        return true;
    };
    if (!push_apart(points, 2 * radius, on_shell)) return std::nullopt;
    for (Vec& point : points) point += centre;
    return points;
}

std::optional<std::vector<Vec>> pack_room(const Room& room, double radius, int count, std::uint64_t seed) {
    const Vec low = room.box.low + Vec::Constant(radius), high = room.box.high - Vec::Constant(radius);
    if ((low.array() > high.array()).any()) return std::nullopt;
    std::vector<Vec> points;
    for (int n = 0; n < count; ++n) {
        Vec point;
        for (int axis = 0; axis < 3; ++axis) {
            const double share = random_number({seed, static_cast<std::uint64_t>(n), static_cast<std::uint64_t>(axis)});
            point[axis] = low[axis] + share * (high[axis] - low[axis]);
        }
        points.push_back(point);
    }
    double widest = 0;
    for (const double other : room.radii) widest = std::max(widest, other);
    const CellGrid obstacles(coordinates(room.centres), room.centres.size(), 3, widest + radius);
    const auto put_back = [&](Vec& point) {
        const Vec before = point;
        bool was_there = true;
        const auto push = [&](double missing, const Vec& along) {
            if (missing <= 0) return;
            was_there = false;
            point += (missing + margin * radius) * along;
        };
        if (!room.centres.empty())
            obstacles.for_each_near(three(before), widest + radius, [&](int k) {
                const auto j = static_cast<std::size_t>(k);
                push(room.radii[j] + radius - (point - room.centres[j]).norm(), direction(point, room.centres[j]));
            });
        for (const WallPlane& plane : room.planes) push(radius - (point - plane.point).dot(plane.normal), plane.normal);
        const Vec inside = point.cwiseMax(low).cwiseMin(high);
        if (inside != point) point = inside;
        return was_there && inside == before;
    };
    for (Vec& point : points) put_back(point);
    if (!push_apart(points, 2 * radius, put_back)) return std::nullopt;
    return points;
}

}  // namespace dmp::mesher
