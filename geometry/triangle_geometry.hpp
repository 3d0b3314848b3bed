// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "geometry/geometry.hpp"
#include "geometry/triangle_soup.hpp"

namespace dmp::geometry {

/// Reads a geometry that is a file of triangles (triangle_file.hpp).
Geometry read_triangle_geometry(const GeometryOptions& options);

/// The geometry that such a file's triangles make up. They must be some. Throws InputError: no unit, corners further
/// out than any geometry can mean, solids that enclose nothing.
Geometry triangle_geometry(TriangleSoup soup, const GeometryOptions& options);

/// The one way on which triangles of a file become parts of a geometry. Each closed group becomes a solid, turned so
/// that it faces outward; the others become surface sets, and where they close a volume together, that is a solid with
/// the file's name. Throws InputError for solids that enclose nothing.
void add_soup(Geometry& geometry, TriangleSoup soup);

/// The error for a geometry without a unit: shows its box, in its own units, as what it may be.
InputError missing_unit(const GeometryOptions& options, const Box& box);

/// A name as scenes have it, of letters, digits and '_': "Body 1 (left)" is "Body_1_left". Empty where nothing is left,
/// or where programs have written a remark in its place ("Created by Gmsh"). At most 100 characters: the end of a
/// longer one is a hash of the whole.
[[nodiscard]] std::string plain_name(const std::string& name);
/// The plain name of a file without its folder and ending; "body" where nothing is left.
[[nodiscard]] std::string name_of_file(const std::string& file);

/// The smallest box around all that lies in 3-D.
[[nodiscard]] Box box_in_space(const Geometry& geometry);

/// Turns a surface outward and says why it is no solid; empty: it is one. `turned` becomes how many triangles changed
/// sides. Throws InputError where it is closed and encloses nothing.
[[nodiscard]] std::string why_open(const std::string& name, TriangleSurface& surface, const std::string& file,
                                   std::size_t* turned = nullptr);

}  // namespace dmp::geometry
