// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// How thick a body is behind a place of its surface.
struct ThicknessSample {
    Vec position = Vec::Zero();  ///< on the surface [m]
    Vec opposite = Vec::Zero();  ///< where the line inward along the normal comes out again [m]
    double thickness = 0;        ///< [m]
    double area = 0;             ///< of the surface that it stands for [m^2]
    double slant = 0;            ///< tangent of the angle between the two sides: 0 where they are parallel
};

/// The thickness of a closed body all over its surface (the shape diameter of Shapira, Shamir and Cohen-Or, The Visual
/// Computer 24 (2008) 249, with the one line along the normal). Of a solid that a liquid fills, it is the gap between
/// the walls.
struct LocalThickness {
    std::vector<ThicknessSample> samples;  ///< by ascending number of their triangle
    double area = 0;                       ///< of the surface, also where it has no opposite side [m^2]

    /// None where no side of the body has an opposite one.
    [[nodiscard]] std::optional<ThicknessSample> thinnest() const;
    /// The share of the surface behind which the body is thinner than a limit [m].
    [[nodiscard]] double share_thinner(double limit) const;
};

/// Measures a closed surface that faces outward in the middles of its triangles; large ones are looked at in several
/// places, about `distance` [m] apart, at most 32 along a side. A side is opposite if it is turned by at most 45
/// degrees: sharper edges are thin, others are edges.
LocalThickness local_thickness(const TriangleSurface& surface, double distance);

}  // namespace dmp::geometry
