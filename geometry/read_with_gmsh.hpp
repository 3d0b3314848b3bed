// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "geometry/geometry.hpp"
#include "geometry/geometry_source.hpp"

namespace dmp::geometry {

/// The part of read_geometry that gmsh and OpenCASCADE do, on a file that is open already. `stage` is told what is
/// going on from now on, for those who wait. Throws InputError.
[[nodiscard]] Geometry read_with_gmsh(const GeometryOptions& options, const GeometrySource& source,
                                      const std::function<void(const char*)>& stage);

}  // namespace dmp::geometry
