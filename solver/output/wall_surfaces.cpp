// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/wall_surfaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dmp::solver {

namespace {

int add_point(FrameGroup& group, const Vec& point, int part) {
    group.id.push_back(static_cast<std::int64_t>(group.id.size()));
    group.part.push_back(part);
    for (const double x : point) group.position.push_back(static_cast<float>(x));
    return static_cast<int>(group.id.size()) - 1;
}

/// A square on the plane, about the foot of the box's middle, as wide as the box is long: it covers what the box shows
/// of the plane.
void add_plane(FrameGroup& group, const WallPlane& plane, const Vec& moved, const Box& shown) {
    const Vec middle = 0.5 * (shown.low + shown.high), point = plane.point + moved;
    const Vec foot = middle - (middle - point).dot(plane.normal) * plane.normal;
    const double half = 0.5 * shown.extent().norm();
    Eigen::Index least = 0;
    plane.normal.cwiseAbs().minCoeff(&least);
    const Vec along = plane.normal.cross(Vec::Unit(least)).normalized(), across = plane.normal.cross(along);
    std::vector<int> corners;
    for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        corners.push_back(add_point(group, foot + half * (u * along + v * across), plane.part));
    for (const int k : {0, 1, 2, 0, 2, 3}) group.triangles.push_back(corners[static_cast<std::size_t>(k)]);
}

}  // namespace

FrameGroup wall_surfaces(const std::string& name, const ParticleSpace& space, const Box& shown,
                         const std::function<bool(int)>& chosen, const std::function<Vec(int)>& displacement) {
    FrameGroup group;
    group.name = name;
    for (const WallPlane& plane : space.wall_planes)
        if (chosen(plane.part)) add_plane(group, plane, displacement(plane.part), shown);
    std::vector<int> number(space.wall_corners.size(), -1);
    for (const WallTriangle& triangle : space.wall_triangles) {
        if (!chosen(triangle.part)) continue;
        for (const int corner : {triangle.a, triangle.b, triangle.c}) {
            int& its = number[static_cast<std::size_t>(corner)];
            if (its < 0)
                its =
                    add_point(group, space.wall_corners[static_cast<std::size_t>(corner)] + displacement(triangle.part),
                              triangle.part);
            group.triangles.push_back(its);
        }
    }
    return group;
}

}  // namespace dmp::solver
