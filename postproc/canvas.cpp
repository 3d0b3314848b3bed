// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/errors.hpp"
#include "base/safe_file.hpp"

namespace dmp::postproc {

namespace {

void set_colour(cairo_t* context, Colour colour) {
    cairo_set_source_rgb(context, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

/// DejaVu Sans if installed (Debian: fonts-dejavu-core, a dependency of fontconfig), otherwise the system's default
/// font.
void set_font(cairo_t* context, const Canvas::TextStyle& style) {
    cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, style.size);
    // independent of the desktop's settings
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

double advance(cairo_t* context, const std::string& words) {
    cairo_text_extents_t extents;
    cairo_text_extents(context, words.c_str(), &extents);
    return extents.x_advance;
}

/// A surface that uses the image's pixels directly.
cairo_surface_t* surface_on(Image& image) {
    auto* pixels = reinterpret_cast<unsigned char*>(image.pixels.data());
    return cairo_image_surface_create_for_data(pixels, CAIRO_FORMAT_RGB24, image.width, image.height, 4 * image.width);
}

}  // namespace

Colour Image::at(int x, int y) const {
    const std::uint32_t pixel =
        pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    return {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
            static_cast<std::uint8_t>(pixel)};
}

std::size_t distinct_colours(const Image& image, std::size_t at_most) {
    std::unordered_set<std::uint32_t> seen;
    for (auto pixel = image.pixels.begin(); pixel != image.pixels.end() && seen.size() < at_most; ++pixel)
        seen.insert(*pixel & 0xffffffU);
    return seen.size();
}

Canvas::Canvas(int width, int height)
    : image_{width, height,
             std::vector<std::uint32_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0xffffff)} {
    cairo_surface_t* surface = surface_on(image_);
    context_.reset(cairo_create(surface));
    cairo_surface_destroy(surface);  // the context keeps it
    if (const cairo_status_t status = cairo_status(context_.get()); status != CAIRO_STATUS_SUCCESS)
        throw ResourceError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels cannot be created: " + cairo_status_to_string(status),
                            "Choose a smaller picture.");
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::fill(double x, double y, double width, double height, Colour colour) {
    const double left = std::round(x), top = std::round(y);  // whole pixels: sharp edges
    set_colour(context_.get(), colour);
    cairo_rectangle(context_.get(), left, top, std::round(x + width) - left, std::round(y + height) - top);
    cairo_fill(context_.get());
}

void Canvas::line(const std::vector<std::array<double, 2>>& points, Colour colour, double thickness) {
    set_colour(context_.get(), colour);
    cairo_set_line_width(context_.get(), thickness);
    constexpr std::size_t piece = 64;  // points; Cairo is slow for long curves that cross themselves
    for (std::size_t first = 0; first < points.size(); first += piece) {
        const std::size_t end = std::min(first + piece + 1, points.size());
        for (std::size_t i = first; i < end; ++i) cairo_line_to(context_.get(), points[i][0], points[i][1]);
        if (end == first + 1) cairo_close_path(context_.get());
        cairo_stroke(context_.get());
    }
}

void Canvas::triangle(const std::array<std::array<double, 2>, 3>& corners, Colour colour) {
    set_colour(context_.get(), colour);
    for (const auto& [x, y] : corners) cairo_line_to(context_.get(), x, y);
    cairo_fill(context_.get());
}

void Canvas::text(double x, double y, const std::string& words, const TextStyle& style) {
    constexpr double capitals = 0.73;  // height of the capitals of DejaVu Sans [font sizes]
    set_font(context_.get(), style);
    const double shift = style.align == Align::left ? 0 : style.align == Align::centre ? 0.5 : 1;
    set_colour(context_.get(), style.colour);
    cairo_move_to(context_.get(), x - shift * advance(context_.get(), words), y + capitals / 2 * style.size);
    cairo_show_text(context_.get(), words.c_str());
    cairo_new_path(context_.get());
}

void Canvas::text_within(double room, double x, double y, const std::string& words, TextStyle style) {
    const double width = text_width(words, style);
    if (width > room) style.size *= room / width;
    text(x, y, words, style);
}

double Canvas::text_width(const std::string& words, const TextStyle& style) {
    const Canvas scratch(1, 1);
    set_font(scratch.context_.get(), style);
    return advance(scratch.context_.get(), words);
}

void Canvas::paste(Image image, int x, int y) {
    cairo_surface_t* surface = surface_on(image);
    cairo_save(context_.get());
    cairo_set_source_surface(context_.get(), surface, x, y);
    cairo_paint(context_.get());
    cairo_restore(context_.get());  // releases the image
    cairo_surface_destroy(surface);
}

std::string Canvas::png() const {
    std::string png;
    const auto append = [](void* text, const unsigned char* bytes, unsigned count) {
        static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
        return CAIRO_STATUS_SUCCESS;
    };
    if (const cairo_status_t status = cairo_surface_write_to_png_stream(cairo_get_target(context_.get()), append, &png);
        status != CAIRO_STATUS_SUCCESS)
        throw ResourceError(std::string("cannot make a picture: ") + cairo_status_to_string(status),
                            "Make room in the memory, then draw it again.");
    return png;
}

void Canvas::save(const std::filesystem::path& file) const { write_file(file, png()); }

}  // namespace dmp::postproc
