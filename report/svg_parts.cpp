// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svg_parts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/unlisted_value.hpp"
#include "report/html.hpp"

namespace dmp::report {

namespace {

const char* anchor_of(SvgAlign align) {
    switch (align) {
        case SvgAlign::start:
            return "start";
        case SvgAlign::middle:
            return "middle";
        case SvgAlign::end:
            return "end";
    }
    unlisted_value(align);
}

}  // namespace

std::string svg_line(PicturePoint from, PicturePoint to, const char* colour, const char* more) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" stroke=\"{}\"{}/>\n", from.x, from.y,
                       to.x, to.y, colour, more);
}

std::string svg_text(PicturePoint at, const std::string& words, SvgAlign align, const std::string& more) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", at.x, at.y, anchor_of(align),
                       more, escaped(words));
}

double svg_text_width(const std::string& words, double size) {
    const auto characters =
        std::ranges::count_if(words, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return 0.62 * size * static_cast<double>(characters);
}

std::string svg_picture(double width, double height, const std::string& label, const std::string& content) {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
               "role=\"img\" aria-label=\"{2}\" font-family=\"system-ui, 'Segoe UI', Roboto, Helvetica, Arial, "
               "sans-serif\" font-size=\"{3}\" fill=\"{4}\">\n<rect width=\"{0}\" height=\"{1}\" "
               "fill=\"#ffffff\"/>\n",
               width, height, escaped(label), svg_text_size, svg_soft) +
           content + "</svg>\n";
}

}  // namespace dmp::report
