// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// The sheet half-way between the two faces of a thin body.
struct MidSurface {
    TriangleSurface surface;
    double thickness = 0;        ///< mean over the faces [m]
    double least = 0, most = 0;  ///< near the corners of their triangles [m]
};

/// What was found out about a body that may be a sheet.
struct SheetSearch {
    std::optional<MidSurface> sheet;
    std::string problem;      ///< why it is none; empty where it is one
    Vec where = Vec::Zero();  ///< where that shows [m]
    double thickness = 0;     ///< there [m]
};

/// The mid-surface of bodies that are sheets: each has two faces that are opposite each other, no further apart than
/// `largest_thickness` [m] and nearly as far everywhere (within a fifth of the mean on nine tenths of them). Triangles
/// are paired by the line inward from their middle, as in local_thickness (geometry/local_thickness.hpp); the larger
/// face is moved inward by half the mean thickness; what lies between the faces' borders, the rim, is left out.
/// @param body closed, faces outward; it may be of several pieces
SheetSearch mid_surface(const TriangleSurface& body, double largest_thickness);

}  // namespace dmp::geometry
