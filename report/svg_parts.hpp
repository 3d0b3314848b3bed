// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/label_places.hpp"

namespace dmp::report {

// Parts of pictures in SVG that need nothing besides themselves: no styles, scripts or fonts of their own.

inline constexpr const char *svg_dark = "#1b1f24", *svg_soft = "#57606a", *svg_grid = "#e8ebef", *svg_frame = "#8c959f";
inline constexpr double svg_text_size = 13;  ///< [px]

enum class SvgAlign { start, middle, end };

/// `more`: attributes.
[[nodiscard]] std::string svg_line(PicturePoint from, PicturePoint to, const char* colour, const char* more = "");
/// `words`: escaped here.
[[nodiscard]] std::string svg_text(PicturePoint at, const std::string& words, SvgAlign align,
                                   const std::string& more = "");

/// About how wide a text is [px]; fonts differ.
[[nodiscard]] double svg_text_width(const std::string& words, double size);

/// A whole picture of this size [px], white. `label`: what screen readers say; `content`: elements.
[[nodiscard]] std::string svg_picture(double width, double height, const std::string& label,
                                      const std::string& content);

}  // namespace dmp::report
