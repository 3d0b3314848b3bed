// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "geometry/triangle_soup.hpp"

namespace dmp::geometry {

/// Whether the file is one of triangles, by its ending: .stl, .obj, .ply or .off.
[[nodiscard]] bool is_triangle_file(const std::string& file);

/// Reads a file of triangles or polygons, whatever its size; coordinates are as written. Throws InputError, with the
/// line of a text: a file that cannot be read, is not what its ending says, ends early, states counts that it does not
/// hold, names corners it has not, or has a number that is not finite; no triangle at all.
TriangleSoup read_triangle_file(const std::string& file, const SourceLocation& location);

// Each reads the whole text of one file, whose name is for errors.

/// STL, text or binary. Its solids are groups.
TriangleSoup read_stl_text(std::string_view text, const std::string& file);
/// Wavefront OBJ: v, f, g and o; curves and free forms are refused, what concerns looks is passed over.
TriangleSoup read_obj_text(std::string_view text, const std::string& file);
/// PLY 1.0 as text or binary of either byte order: the elements vertex and face.
TriangleSoup read_ply_text(std::string_view text, const std::string& file);
/// Geomview's OFF as text, also with colours, normals or texture coordinates of its corners (COFF, NOFF, STOFF).
TriangleSoup read_off_text(std::string_view text, const std::string& file);

}  // namespace dmp::geometry
