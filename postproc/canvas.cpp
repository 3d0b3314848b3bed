// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "base/safe_file.hpp"
#include "postproc/vtk_messages.hpp"

namespace dmp::postproc {

namespace {

using Point = std::array<double, 2>;

std::size_t offset(const Image& image, int x, int y) {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

double distance_to_segment(double x, double y, const Point& a, const Point& b) {
    const double dx = b[0] - a[0];
    const double dy = b[1] - a[1];
    const double length2 = dx * dx + dy * dy;
    const double along = length2 > 0 ? std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(x - a[0] - along * dx, y - a[1] - along * dy);
}

/// Text at 72 dots per inch, so that sizes are pixels, as white letters whose alpha is the ink.
struct TextImage {
    vtkNew<vtkImageData> pixels;
    std::array<int, 2> size{};
};

/// DejaVu Sans where the system has it (Debian: fonts-dejavu-core, which fontconfig brings), else VTK's own font.
void set_font(vtkTextProperty* property, bool bold) {
    const std::filesystem::path folder = "/usr/share/fonts/truetype/dejavu";
    const std::filesystem::path file = folder / (bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf");
    property->SetFontFamilyToArial();
    property->SetBold(bold ? 1 : 0);
    if (!std::filesystem::exists(file)) return;
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(file.c_str());
}

void render(TextImage& image, const std::string& words, const Canvas::TextStyle& style) {
    const VtkMessages quiet;
    vtkNew<vtkTextProperty> property;
    set_font(property, style.bold);
    property->SetFontSize(static_cast<int>(std::lround(style.size)));
    property->SetOrientation(style.upward ? 90 : 0);
    property->SetColor(1, 1, 1);
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    if (renderer == nullptr ||
        !renderer->RenderString(property, words, image.pixels, image.size.data(), 72, vtkTextRenderer::FreeType))
        image.size = {0, 0};
}

}  // namespace

Colour Image::at(int x, int y) const {
    const std::size_t i = offset(*this, x, y);
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
}

std::size_t distinct_colours(const Image& image, std::size_t at_most) {
    std::unordered_set<std::uint32_t> seen;
    for (std::size_t i = 0; i + 2 < image.rgb.size() && seen.size() < at_most; i += 3)
        seen.insert(static_cast<std::uint32_t>(image.rgb[i] << 16 | image.rgb[i + 1] << 8 | image.rgb[i + 2]));
    return seen.size();
}

Canvas::Canvas(int width, int height)
    : image_{width, height,
             std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255)} {}

void Canvas::blend(int x, int y, Colour colour, double cover) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height || cover <= 0) return;
    const double share = std::min(cover, 1.0);
    std::uint8_t* pixel = &image_.rgb[offset(image_, x, y)];
    const auto mix = [share](std::uint8_t below, std::uint8_t above) {
        return static_cast<std::uint8_t>(std::lround((1 - share) * below + share * above));
    };
    pixel[0] = mix(pixel[0], colour.red);
    pixel[1] = mix(pixel[1], colour.green);
    pixel[2] = mix(pixel[2], colour.blue);
}

void Canvas::fill(double x, double y, double width, double height, Colour colour) {
    const int right = static_cast<int>(std::lround(x + width));
    const int bottom = static_cast<int>(std::lround(y + height));
    for (int row = static_cast<int>(std::lround(y)); row < bottom; ++row)
        for (int column = static_cast<int>(std::lround(x)); column < right; ++column) blend(column, row, colour, 1);
}

void Canvas::line(const std::vector<Point>& points, Colour colour, double thickness) {
    if (points.empty()) return;
    const double reach = thickness / 2 + 1;
    double left = points[0][0], right = left, top = points[0][1], bottom = top;
    for (const Point& p : points) {
        left = std::min(left, p[0]);
        right = std::max(right, p[0]);
        top = std::min(top, p[1]);
        bottom = std::max(bottom, p[1]);
    }
    const int x0 = std::max(0, static_cast<int>(std::floor(left - reach)));
    const int y0 = std::max(0, static_cast<int>(std::floor(top - reach)));
    const int width = std::min(image_.width, static_cast<int>(std::ceil(right + reach)) + 1) - x0;
    const int height = std::min(image_.height, static_cast<int>(std::ceil(bottom + reach)) + 1) - y0;
    if (width <= 0 || height <= 0) return;

    // the ink of all segments first, so that joints are not painted twice
    std::vector<float> ink(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& a = points[i];
        const Point& b = points[std::min(i + 1, points.size() - 1)];
        const int first_row = std::max(y0, static_cast<int>(std::floor(std::min(a[1], b[1]) - reach)));
        const int last_row = std::min(y0 + height - 1, static_cast<int>(std::ceil(std::max(a[1], b[1]) + reach)));
        const int first_column = std::max(x0, static_cast<int>(std::floor(std::min(a[0], b[0]) - reach)));
        const int last_column = std::min(x0 + width - 1, static_cast<int>(std::ceil(std::max(a[0], b[0]) + reach)));
        for (int y = first_row; y <= last_row; ++y)
            for (int x = first_column; x <= last_column; ++x) {
                const double cover = thickness / 2 + 0.5 - distance_to_segment(x + 0.5, y + 0.5, a, b);
                float& here = ink[static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x - x0)];
                here = std::max(here, static_cast<float>(std::clamp(cover, 0.0, 1.0)));
            }
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            blend(x0 + x, y0 + y, colour,
                  ink[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]);
}

void Canvas::triangle(const std::array<Point, 3>& corners, Colour colour) {
    const auto [left, right] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
    const auto [top, bottom] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
    const auto side = [](const Point& a, const Point& b, double x, double y) {
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    for (int y = static_cast<int>(std::floor(top)); y <= static_cast<int>(std::ceil(bottom)); ++y)
        for (int x = static_cast<int>(std::floor(left)); x <= static_cast<int>(std::ceil(right)); ++x) {
            int inside = 0;  // of 16 places in the pixel
            for (int k = 0; k < 16; ++k) {
                const int row = k / 4, column = k % 4;
                const double px = x + (column + 0.5) / 4;
                const double py = y + (row + 0.5) / 4;
                const double a = side(corners[0], corners[1], px, py);
                const double b = side(corners[1], corners[2], px, py);
                const double c = side(corners[2], corners[0], px, py);
                inside += (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0) ? 1 : 0;
            }
            blend(x, y, colour, inside / 16.0);
        }
}

void Canvas::text(double x, double y, const std::string& words, const TextStyle& style) {
    TextImage image;
    render(image, words, style);
    const int width = image.size[0];
    const int height = image.size[1];
    const double shift = style.align == Align::left ? 0.0 : style.align == Align::centre ? 0.5 : 1.0;
    const int left = static_cast<int>(std::lround(style.upward ? x - width / 2.0 : x - shift * width));
    const int top = static_cast<int>(std::lround(style.upward ? y - (1 - shift) * height : y - height / 2.0));
    int extent[6];
    image.pixels->GetExtent(extent);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto* pixel = static_cast<const unsigned char*>(
                image.pixels->GetScalarPointer(extent[0] + column, extent[2] + height - 1 - row, 0));
            blend(left + column, top + row, style.colour, pixel[3] / 255.0);
        }
}

void Canvas::text_within(double room, double x, double y, const std::string& words, TextStyle style) {
    const double width = text_width(words, style);
    if (width > room) style.size = std::max(1.0, style.size * room / width);
    text(x, y, words, style);
}

double Canvas::text_width(const std::string& words, const TextStyle& style) {
    TextImage image;
    render(image, words, style);
    return image.size[0];
}

void Canvas::paste(const Image& image, int x, int y) {
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) blend(x + column, y + row, image.at(column, row), 1);
}

void Canvas::save(const std::filesystem::path& file) const {
    const VtkMessages messages;
    vtkNew<vtkImageData> data;
    data->SetDimensions(image_.width, image_.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int row = 0; row < image_.height; ++row)
        std::copy_n(&image_.rgb[offset(image_, 0, row)], 3 * image_.width,
                    static_cast<unsigned char*>(data->GetScalarPointer(0, image_.height - 1 - row, 0)));
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(data);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (bytes == nullptr || bytes->GetNumberOfValues() == 0) throw_write_error(file, messages.text());
    write_file(file, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                      static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

}  // namespace dmp::postproc
