// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// Whether a geometry is a gmsh script (.geo, .geo_unrolled), by its extension.
[[nodiscard]] bool is_script(const std::string& file);

/// Whether a geometry is of OpenCASCADE's formats (STEP, IGES, BREP), by its extension.
[[nodiscard]] bool is_cad_file(const std::string& file);

[[nodiscard]] bool is_iges_file(const std::string& file);

/// Whether the format states its unit: STEP and IGES.
[[nodiscard]] bool states_its_unit(const std::string& file);

/// Whether the scene must give the unit: files of triangles and BREP.
[[nodiscard]] bool needs_a_unit(const std::string& file);

/// Whether all its edges are straight as they are: meshes and files of triangles.
[[nodiscard]] bool has_straight_edges_only(const std::string& file);

/// The whole content of a file; throws InputError when it cannot be read.
[[nodiscard]] std::string file_text(const std::string& file);

/// What can be said before gmsh sees the geometry. Throws InputError: no such file, a folder, unreadable, a format we
/// do not read, options that make no sense, and mistakes in a script that gmsh would pass over in silence.
void check_geometry_file(const GeometryOptions& options);

/// Throws InputError where a place [m] of the geometry is not finite, or further out than any geometry can mean (10^12
/// m): products of such lengths would overflow.
void check_coordinates(const Vec& position, const std::string& file);

}  // namespace dmp::geometry
