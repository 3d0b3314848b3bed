// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "geometry/geometry.hpp"
#include "mesher/mesh.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// Volume [m^3], in 2-D area [m^2], centroid [m] and second moments about it, the integral of (X - c) (X - c)^T.
struct Moments {
    double volume = 0;
    Vec centroid = Vec::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

/// Of a polygon, exactly.
Moments moments_of(const Polyline& outline);
/// Of what a closed surface holds, exactly.
Moments moments_of(const TriangleSurface& surface);
/// Of cells, by their volumes, centroids and second moments along the axes; those between two axes within a cell are
/// not known, and are left out.
Moments moments_of(const SolidCells& cells);

/// Of a part that was drawn as a straight bar of one cross-section: its length is more than three times its width, and
/// agrees within 2 % with that of a bar with its moments, (12 I / V)^(1/2). None otherwise, where the area has several
/// outlines or the surface holes, or the cells go on through a periodic side. EA = E V / L and EI = E I / L across its
/// axis, of its cells and of what was drawn; in 2-D with E / (1 - nu^2).
std::optional<MeshReport::SpringLine::Bar> bar_of(const Part& part, const Region& drawn, const SolidCells& cells);
std::optional<MeshReport::SpringLine::Bar> bar_of(const Part& part, const TriangleSurface& drawn,
                                                  const SolidCells& cells);

}  // namespace dmp::mesher
