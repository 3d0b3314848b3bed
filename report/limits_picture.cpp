// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/limits_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "base/unlisted_value.hpp"
#include "report/html.hpp"
#include "report/log_axis.hpp"
#include "report/svg_parts.hpp"

namespace dmp::report {

namespace {

using Dial = LimitsFacts::Dial;

/// Of the picture, and of the plot in it [px].
struct Layout {
    static constexpr double width = 720, left = 258, right = 696, top = 96;
    static constexpr double row_height = 26, bar_height = 12, label_size = 11.5, line_height = 17;
};
constexpr const char *clean_colour = "#0072b2", *pale_colour = "#a6cbe3", *break_colour = "#d55e00";
constexpr std::size_t longest_dial = 34;

/// Both sides of one value.
struct Row {
    std::string name;
    std::vector<const Dial*> sides;
};

std::vector<Row> rows_of(const LimitsFacts& limits) {
    std::vector<Row> rows;
    for (const Dial& dial : limits.dials) {
        auto row = std::ranges::find(rows, dial.name, &Row::name);
        if (row == rows.end()) row = rows.insert(rows.end(), {dial.name, {}});
        row->sides.push_back(&dial);
    }
    return rows;
}

std::vector<double> factors_of(const LimitsFacts& limits) {
    std::vector<double> all{1};
    for (const Dial& dial : limits.dials)
        for (const auto& value : {dial.stated, dial.clean, dial.bad})
            if (value) all.push_back(*value / dial.own);
    return all;
}

std::string bar(double from, double to, double y, const char* colour) {
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n",
                       std::min(from, to), y - Layout::bar_height / 2, std::abs(to - from), Layout::bar_height, colour);
}

/// How the values end there, or go on.
std::string end_mark(LimitWay way, double x, double y, bool is_up) {
    const auto path = [&](const std::string& d, const char* fill, const char* stroke) {
        return fmt::format(
            "<path d=\"M{:.1f} {:.1f}{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\"/>\n",
            x, y, d, fill, stroke);
    };
    switch (way) {
        case LimitWay::not_measured:
        case LimitWay::no_measure:
            return "";
        case LimitWay::none_found:
            return path(is_up ? "m1 -4l5 4l-5 4" : "m-1 -4l-5 4l5 4", "none", svg_soft);
        case LimitWay::departs:
            return path("m0 -5.5l5.5 5.5l-5.5 5.5l-5.5 -5.5z", "#ffffff", break_colour);
        case LimitWay::breaks:
            return path("m-4.5 -4.5l9 9m0 -9l-9 9", "none", break_colour);
        case LimitWay::refused:
            return path("m0 -7v14", "none", svg_dark);
    }
    unlisted_value(way);
}

class LimitsPlot {
  public:
    explicit LimitsPlot(const LimitsFacts& limits)
        : rows_(rows_of(limits)),
          axis_(factors_of(limits), Layout::left, Layout::right),
          bottom_(Layout::top + Layout::row_height * count()) {}

    [[nodiscard]] double bottom() const { return bottom_; }

    [[nodiscard]] std::string svg() const {
        std::string all;
        for (const LogTick& tick : axis_.numbers(34)) {
            const double x = axis_.at_log10(tick.log10);
            all += svg_line({x, Layout::top}, {x, bottom_}, svg_grid) +
                   svg_text({x, bottom_ + 16}, tick.text, SvgAlign::middle);
        }
        for (std::size_t k = 0; k < rows_.size(); ++k)
            all += row(rows_[k], Layout::top + Layout::row_height * (static_cast<double>(k) + 0.5));
        const double own = axis_.at(1);
        return all + svg_line({own, Layout::top}, {own, bottom_}, svg_dark, " class=\"own\"") +
               svg_line({Layout::left, bottom_}, {Layout::right, bottom_}, svg_frame) +
               svg_text({(Layout::left + Layout::right) / 2, bottom_ + 36}, "multiple of the scene's own value",
                        SvgAlign::middle);
    }

  private:
    [[nodiscard]] double count() const { return static_cast<double>(rows_.size()); }

    [[nodiscard]] std::string row(const Row& of, double y) const {
        std::string all = svg_text({Layout::left - 8, y + 4}, shortened(of.name, longest_dial), SvgAlign::end,
                                   fmt::format(" font-size=\"{}\" fill=\"{}\"", Layout::label_size, svg_dark));
        for (const Dial* dial : of.sides) all += side(*dial, y);
        return all;
    }

    [[nodiscard]] std::string side(const Dial& dial, double y) const {
        const auto at = [&](double value) { return axis_.at(value / dial.own); };
        const double own = axis_.at(1), clean = dial.clean ? at(*dial.clean) : own;
        std::string all = fmt::format("<g class=\"dial\"><title>{}</title>\n", escaped(words_of(dial)));
        all += bar(own, clean, y, clean_colour);
        if (dial.bad) all += bar(clean, at(*dial.bad), y, pale_colour);
        if (dial.stated) {
            const double x = at(*dial.stated);
            all += svg_line({x, y - Layout::row_height / 2 + 2}, {x, y + Layout::row_height / 2 - 2}, svg_dark,
                            " class=\"stated\" stroke-width=\"2\" stroke-dasharray=\"3 2\"");
        }
        return all + end_mark(dial.way, dial.bad ? at(*dial.bad) : clean, y, dial.is_up) + "</g>\n";
    }

    static std::string words_of(const Dial& dial) {
        return dial.name + (dial.is_up ? " up: " : " down: ") + limit_way_text(dial) + "; own " +
               limit_value_text(dial.own, dial.unit) + ", stated " + limit_value_text(dial.stated, dial.unit) +
               ", last clean " + limit_value_text(dial.clean, dial.unit) + ", first bad " +
               limit_value_text(dial.bad, dial.unit);
    }

    std::vector<Row> rows_;
    LogAxis axis_;
    double bottom_;
};

std::string legend() {
    constexpr double y = Layout::top - 22, gap = 18;
    double x = 24;
    std::string all;
    const auto add = [&](const std::string& symbol, double symbol_width, const std::string& words) {
        all += symbol + svg_text({x + symbol_width, y + 4.5}, words, SvgAlign::start);
        x += symbol_width + svg_text_width(words, svg_text_size) + gap;
    };
    add(bar(x, x + 18, y, clean_colour), 24, "clean");
    add(svg_line({x + 4, y - 8}, {x + 4, y + 8}, svg_dark, " stroke-width=\"2\" stroke-dasharray=\"3 2\""), 12,
        "stated limit");
    add(end_mark(LimitWay::breaks, x + 6, y, true), 17, "breaks");
    add(end_mark(LimitWay::departs, x + 6, y, true), 17, "measures depart");
    add(end_mark(LimitWay::refused, x + 4, y, true), 12, "refused");
    add(end_mark(LimitWay::none_found, x + 2, y, true), 14, "none found");
    return all;
}

}  // namespace

std::string limits_picture(const LimitsFacts& limits) {
    const LimitsPlot plot(limits);
    const auto unmeasured = std::ranges::count(limits.dials, LimitWay::not_measured, &Dial::way) +
                            std::ranges::count(limits.dials, LimitWay::no_measure, &Dial::way);
    const double height = plot.bottom() + 50 + (unmeasured > 0 ? 6 + Layout::line_height : 0);
    const std::string name = shortened(limits.name, 56);
    const std::string what = fmt::format("where its models end, by runs of {:.4g} s", limits.simulated);
    std::string all = svg_text({24, 30}, name, SvgAlign::start,
                               fmt::format(" font-size=\"16\" font-weight=\"600\" fill=\"{}\"", svg_dark)) +
                      svg_text({24, 50}, what, SvgAlign::start) + legend() + plot.svg();
    if (unmeasured > 0)
        all += svg_text({24, plot.bottom() + 56}, fmt::format("Not measured to the end: {}.", unmeasured),
                        SvgAlign::start);
    return svg_picture(Layout::width, height, name + ": " + what, all);
}

void write_limits_picture(const std::filesystem::path& folder) {
    write_file(folder / limits_picture_name, limits_picture(read_limits_facts(folder / limits_file_name)));
}

}  // namespace dmp::report
