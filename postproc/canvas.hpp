// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "postproc/colour_map.hpp"

namespace dmp::postproc {

/// 8-bit RGB, top row first.
struct Image {
    int width = 0, height = 0;  ///< [pixels]
    std::vector<std::uint8_t> rgb;

    [[nodiscard]] Colour at(int x, int y) const;
};

/// How many colours there are, counted up to `at_most`: a picture of one colour shows nothing.
std::size_t distinct_colours(const Image& image, std::size_t at_most = 4096);

enum class Align { left, centre, right };

/// A white sheet to draw on: x to the right, y down, in pixels from the top left corner. Needs no display.
class Canvas {
  public:
    Canvas(int width, int height);

    struct TextStyle {
        double size = 20;  ///< [pixels]
        Align align = Align::left;
        bool bold = false;
        bool upward = false;  ///< read from bottom to top
        Colour colour = colours::ink;
    };

    void fill(double x, double y, double width, double height, Colour colour);
    /// A smooth line through the points.
    void line(const std::vector<std::array<double, 2>>& points, Colour colour, double thickness);
    void triangle(const std::array<std::array<double, 2>, 3>& corners, Colour colour);
    /// One line of text, its middle height at y, its left end, centre or right end at x (upward: x and y swapped).
    void text(double x, double y, const std::string& words, const TextStyle& style);
    /// The same, smaller where it would be wider than `room` pixels.
    void text_within(double room, double x, double y, const std::string& words, TextStyle style);
    void paste(const Image& image, int x, int y);

    /// Width of the text [pixels].
    [[nodiscard]] static double text_width(const std::string& words, const TextStyle& style);

    [[nodiscard]] const Image& image() const { return image_; }
    /// Writes a PNG. Throws ResourceError when the disk does not take it.
    void save(const std::filesystem::path& file) const;

  private:
    void blend(int x, int y, Colour colour, double cover);

    Image image_;
};

}  // namespace dmp::postproc
