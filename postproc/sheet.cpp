// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/sheet.hpp"

#include <algorithm>
#include <cmath>

#include "postproc/axis.hpp"

namespace dmp::postproc {

namespace {

// all in pixels for a sheet 1600 pixels wide
constexpr double margin = 40;
constexpr double gap = 32;  // between columns
constexpr double title_height = 84;
constexpr double caption_height = 44;  // above each panel, if there are several
constexpr double panel_gap = 14;       // below each panel
constexpr double foot_height = 120;
constexpr double least_width = 760;   // space for the foot
constexpr double most_height = 1500;  // of all panels together

}  // namespace

/// Sizes in pixels, computed before drawing.
struct Sheet::Layout {
    double unit;
    int columns, rows, panel_width, panel_height, width, height;
    double pitch_x, pitch_y, left;
};

namespace {

/// The largest panels that fit; compares all numbers of columns.
struct Panels {
    int columns = 1;
    double width = 0, height = 0;
};

Panels largest_panels(double aspect, int count, double unit, double sheet_width) {
    Panels best;
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const double captions = count > 1 ? caption_height : 0.0;
        const double room_x = (sheet_width - 2 * margin * unit - (columns - 1) * gap * unit) / columns;
        const double room_y = most_height * unit / rows - (captions + panel_gap) * unit;
        const double width = std::min(room_x, room_y * aspect);
        if (width > best.width * (1 + 1e-9)) best = {columns, width, width / aspect};
    }
    return best;
}

}  // namespace

Sheet::Sheet(const Box& area, std::size_t panels, int width, const std::string& title)
    : Sheet(
          [&] {
              const int count = static_cast<int>(panels);
              Layout layout{};
              layout.unit = width / 1600.0;
              const double aspect = area.extent().x() / area.extent().y();
              const Panels best = largest_panels(aspect, count, layout.unit, width);
              layout.columns = best.columns;
              layout.rows = (count + best.columns - 1) / best.columns;
              layout.panel_width = std::max(1, static_cast<int>(std::lround(best.width)));
              layout.panel_height = std::max(1, static_cast<int>(std::lround(best.height)));
              const double captions = count > 1 ? caption_height * layout.unit : 0.0;
              layout.pitch_x = layout.panel_width + gap * layout.unit;
              layout.pitch_y = layout.panel_height + captions + panel_gap * layout.unit;
              const double drawn = layout.columns * layout.pitch_x - gap * layout.unit;
              const double sheet_width = std::max(drawn + 2 * margin * layout.unit, least_width * layout.unit);
              layout.left = (sheet_width - drawn) / 2;
              layout.width = static_cast<int>(std::lround(sheet_width));
              layout.height = static_cast<int>(
                  std::lround((title_height + foot_height) * layout.unit + layout.rows * layout.pitch_y));
              return layout;
          }(),
          area, title) {}

Sheet::Sheet(const Layout& layout, const Box& area, const std::string& title)
    : unit_(layout.unit),
      columns_(layout.columns),
      rows_(layout.rows),
      panel_width_(layout.panel_width),
      panel_height_(layout.panel_height),
      pitch_x_(layout.pitch_x),
      pitch_y_(layout.pitch_y),
      left_(layout.left),
      head_(title_height * layout.unit),
      pixels_per_metre_(layout.panel_width / area.extent().x()),
      canvas_(layout.width, layout.height) {
    const double room_for_time = layout.columns * layout.rows == 1 ? 220 * unit_ : 0;
    canvas_.text_within(layout.width - 2 * margin * unit_ - room_for_time, margin * unit_, 46 * unit_, title,
                        {30 * unit_, Align::left, true});
}

void Sheet::add(const Image& image, const std::string& caption) {
    const bool alone = columns_ * rows_ == 1;
    const int row = added_ / columns_, column = added_ % columns_;
    const double x = left_ + column * pitch_x_;
    const double y = head_ + row * pitch_y_;
    ++added_;
    if (alone) {
        canvas_.text(canvas_.image().width - margin * unit_, 46 * unit_, caption, {28 * unit_, Align::right});
    } else {
        canvas_.text(x, y + 0.55 * caption_height * unit_, caption, {22 * unit_, Align::left});
    }
    canvas_.paste(image, static_cast<int>(std::lround(x)),
                  static_cast<int>(std::lround(y + (alone ? 0.0 : caption_height * unit_))));
}

void Sheet::finish(const ColourScale& scale) {
    const double top = head_ + rows_ * pitch_y_ + 12 * unit_;
    draw_length(top);
    if (scale.shown) draw_colours(scale, top);
}

void Sheet::draw_length(double top) {
    const double length = round_below(std::min(0.2 * canvas_.image().width, 1.0 * panel_width_) / pixels_per_metre_);
    const double x = margin * unit_;
    const double y = top + 42 * unit_;
    const double pixels = length * pixels_per_metre_;
    const double thick = std::max(2.0, 4 * unit_);
    const double tick = 8 * unit_;
    canvas_.fill(x, y, pixels, thick, colours::ink);
    canvas_.fill(x, y - tick, thick / 2, 2 * tick + thick, colours::ink);
    canvas_.fill(x + pixels - thick / 2, y - tick, thick / 2, 2 * tick + thick, colours::ink);
    canvas_.text(x + pixels / 2, y - 22 * unit_, printed_length(length, length), {22 * unit_, Align::centre});
}

void Sheet::draw_colours(const ColourScale& scale, double top) {
    const double right = canvas_.image().width - (margin + 26) * unit_;
    const double width = 0.46 * canvas_.image().width;
    const double left = right - width;
    const double y = top + 34 * unit_;
    const double height = 20 * unit_;
    const ColourMap& map = scale.map;
    for (int column = 0; column < width; ++column) {
        const double value = map.low() + (map.high() - map.low()) * (column + 0.5) / width;
        canvas_.fill(left + column, y, 1, height, map(value));
    }
    // triangles at the ends: there are values beyond them
    const double reach = 16 * unit_;
    if (scale.beyond_low)
        canvas_.triangle({{{left, y}, {left, y + height}, {left - reach, y + height / 2}}}, map(map.low()));
    if (scale.beyond_high)
        canvas_.triangle({{{left + width, y}, {left + width, y + height}, {left + width + reach, y + height / 2}}},
                         map(map.high()));
    // A label such as 0.0025 is about 70 units wide.
    const int room = static_cast<int>(width / (95 * unit_));
    const Ticks ticks = round_ticks(map.low(), map.high(), std::clamp(room, 2, 5));
    for (std::size_t i = 0; i < ticks.value.size(); ++i) {
        const double x = left + width * (ticks.value[i] - map.low()) / (map.high() - map.low());
        canvas_.fill(x - unit_, y + height, 2 * unit_, 6 * unit_, colours::frame);
        canvas_.text(x, y + height + 22 * unit_, ticks.text[i], {20 * unit_, Align::centre});
    }
    canvas_.text(left + width / 2, y - 20 * unit_, scale.label, {22 * unit_, Align::centre});
}

}  // namespace dmp::postproc
