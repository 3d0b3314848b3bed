// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// Makes one corner of those that lie within a distance of each other [m]; 0: of those with equal coordinates. A corner
/// that stays keeps its place, none is moved further than the distance. Returns how many corners are gone, those that
/// no triangle has among them.
std::size_t weld_corners(TriangleSurface& surface, double distance);

/// What drop_useless_triangles left out.
struct DroppedTriangles {
    std::size_t without_area = 0;
    std::size_t duplicates = 0;   ///< a triangle with the same three corners is there already
    std::size_t inner_walls = 0;  ///< two triangles with the same corners that face each other: bodies that touch
};

/// Leaves out the triangles that bound nothing: those without area, and all but one of those with the same three
/// corners, or all of them if as many face one side as the other and the surface does not become open by that.
DroppedTriangles drop_useless_triangles(TriangleSurface& surface);

}  // namespace dmp::geometry
