// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// Values as bytes, bit for bit, for another process of the same program on the same machine; no file format.
[[nodiscard]] std::string bytes_of(const Geometry& geometry);
[[nodiscard]] std::string bytes_of(const GeometryOptions& options);  ///< without its selections

/// What was told of an error.
struct ErrorText {
    SourceLocation location;
    std::string problem, what_to_do;
};
[[nodiscard]] std::string bytes_of(const ErrorText& error);

/// The values again. Throws std::runtime_error for bytes that end early or go on, or that no value has; of a geometry,
/// all points are finite, and triangles' corners exist. Memory stays within a few times that of the bytes, whatever
/// they say.
[[nodiscard]] Geometry geometry_of(std::string_view bytes);
[[nodiscard]] GeometryOptions geometry_options_from_bytes(std::string_view bytes);
[[nodiscard]] ErrorText error_text_of(std::string_view bytes);

}  // namespace dmp::geometry
