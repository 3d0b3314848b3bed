// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "geometry/geometry.hpp"

namespace dmp {

/// Whether a drawing is a gmsh script (.geo, .geo_unrolled), by its extension.
[[nodiscard]] bool is_script(const std::string& file);

/// The whole content of a file; throws InputError when it cannot be read.
[[nodiscard]] std::string file_text(const std::string& file);

/// What can be said before gmsh sees the drawing. Throws InputError: no such file, a folder, unreadable, a format we do
/// not read, options that make no sense, and mistakes in a script that gmsh would pass over in silence.
void check_drawing_file(const DrawingOptions& options);

}  // namespace dmp
