// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/vec.hpp"

namespace dmp::geometry {

/// A surface of triangles in 3-D, with corners that triangles share.
struct TriangleSurface {
    std::vector<Vec> corners;                   ///< each once [m]
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
    std::size_t left_out = 0;                   ///< triangles of the file without an area, which touch nothing
    /// Holes are left: what is inside says its winding number, more than one half (geometry/winding_number.hpp).
    bool has_holes = false;

    [[nodiscard]] double area() const;
    /// Of a closed surface whose triangles face outward [m^3].
    [[nodiscard]] double enclosed_volume() const;
};

/// Reads an STL file, text or binary, whatever its ending; `unit` is the length of one unit of the file [m], `place`
/// where the scene names the file. Corners with equal coordinates are one. Throws InputError, with the line of a text
/// file: a file that cannot be read, is no STL, ends early or holds a number that is not finite; no triangle at all.
TriangleSurface read_stl(const std::string& file, double unit, const SourceLocation& location);

}  // namespace dmp::geometry
