// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesher/mesh.hpp"

namespace dmp::mesher {

/// What was found out about each particle, for pictures.
struct MeshDetail {
    std::vector<float> kernel_sum;     ///< SUM V W over all particles about it [-]
    std::vector<float> surface_error;  ///< of fluid within a spacing of its drawn surface [spacings]; else NaN
};

/// The figures that cost more than a mesh itself: adds surface errors, layers and the leak test to the report. For
/// scenes of spheres it does nothing.
MeshDetail inspect(MeshResult& result, const Geometry& geometry, const Scene& scene);

}  // namespace dmp::mesher
