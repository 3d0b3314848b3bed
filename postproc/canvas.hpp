// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <cairo/cairo.h>

#include "postproc/colour_map.hpp"

namespace dmp::postproc {

struct Image {
    int width = 0, height = 0;          ///< [pixels]
    std::vector<std::uint32_t> pixels;  ///< 0xRRGGBB, top row first

    [[nodiscard]] Colour at(int x, int y) const;
};

/// Number of different colours, counted up to `at_most`: a picture with one colour is blank.
std::size_t distinct_colours(const Image& image, std::size_t at_most = 4096);

enum class Align { left, centre, right };

/// A white drawing surface (Cairo): x to the right, y down, in pixels from the top left corner. Needs no display.
class Canvas {
  public:
    static constexpr int largest = 32'000;  ///< width and height [pixels]; Cairo's limit is 32767

    /// Throws ResourceError if Cairo cannot create a surface of this size.
    Canvas(int width, int height);

    struct TextStyle {
        double size = 20;  ///< [pixels]
        Align align = Align::left;
        bool bold = false;
        Colour colour = colours::ink;
    };

    void fill(double x, double y, double width, double height, Colour colour);
    /// A line through the points, with round ends; a dot if there is only one point.
    void line(const std::vector<std::array<double, 2>>& points, Colour colour, double thickness);
    void triangle(const std::array<std::array<double, 2>, 3>& corners, Colour colour);
    /// One line of text with the middle of its capitals at y, and its left end, centre or right end at x.
    void text(double x, double y, const std::string& words, const TextStyle& style);
    /// The same in a smaller font if it would be wider than `room` pixels.
    void text_within(double room, double x, double y, const std::string& words, TextStyle style);
    void paste(Image image, int x, int y);

    /// Width of the text [pixels].
    [[nodiscard]] static double text_width(const std::string& words, const TextStyle& style);

    [[nodiscard]] const Image& image() const { return image_; }
    /// The bytes of a PNG file. Throws ResourceError if there is no room for them.
    [[nodiscard]] std::string png() const;
    /// Writes a PNG file. Throws ResourceError if it cannot be written.
    void save(const std::filesystem::path& file) const;

  private:
    struct Release {
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };

    Image image_;
    std::unique_ptr<cairo_t, Release> context_;  ///< draws on the pixels of image_
};

}  // namespace dmp::postproc
