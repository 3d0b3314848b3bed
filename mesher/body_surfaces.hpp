// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesher/mesh.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// An elastic part that stands to both sides of its middle: a strip in 2-D, a shell in 3-D.
struct Sheet {
    const Part* part;
    double thickness;           ///< of the material [m]
    CurveSet curves{};          ///< the middle in 2-D
    TriangleSurface surface{};  ///< the middle in 3-D
};

/// How thick a strip is: `thickness`, or its mass per length over the density of the densest fluid [m].
double strip_thickness(const Part& strip, const Scene& scene);

/// How far apart the two sides of a sheet are that touch others: its thickness, in a liquid that of its rows of
/// particles at most [m].
double thickness_between_sides(const Sheet& sheet, const Scene& scene);

/// Gives each elastic particle the surface of its solid in front of it (SolidSurface): the drawn outline of an area or
/// a volume, without what lies on periodic sides and planes of symmetry, where the solid goes on; of a sheet half its
/// thickness from its middle. Notes how thick sheets are, and warns of those that are thicker than their rows.
void find_body_surfaces(const Geometry& geometry, const Scene& scene, const std::vector<Sheet>& sheets,
                        MeshResult& result);

}  // namespace dmp::mesher
