// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/commands.hpp"
#include "cli/uses.hpp"
#include "geometry/geometry.hpp"

namespace dmp::cli {

/// What a geometry holds, for a person. Where `unit_known` is false, lengths are the file's own numbers, and the box is
/// shown as what it may be.
[[nodiscard]] std::string geometry_text(const Geometry& geometry, bool unit_known);

/// The same as JSON, lengths in metres: "file", "dimension", "unit" ("metres", "source"; null where it is unknown),
/// "box", "parts" (each with "name", "kind" and what its kind has: "volume", "area", "length", "triangles",
/// "watertight", "box", "why_open") and "warnings".
[[nodiscard]] std::string geometry_json(const Geometry& geometry, bool unit_known);

/// The triangles at the open edges (and at others that no closed surface has) of all that should have been solids.
[[nodiscard]] TriangleSurface bad_triangles(const Geometry& geometry);

/// The options for a geometry named on the command line, its unit as "mm", "1 mm" or "". Throws InputError.
[[nodiscard]] GeometryOptions geometry_options(const std::string& file, const std::string& unit);

/// Reads it, in the file's own units where it has none; surfaces follow the geometry to a thousandth of its size.
[[nodiscard]] Geometry read_for_inspection(GeometryOptions options, const GeometryReading& reading);

}  // namespace dmp::cli
