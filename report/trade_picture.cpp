// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/trade_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/length_text.hpp"
#include "base/safe_file.hpp"
#include "report/html.hpp"
#include "report/label_places.hpp"
#include "report/log_axis.hpp"
#include "report/svg_parts.hpp"

namespace dmp::report {

namespace {

constexpr double width = 720, left = 72, right = 700, top = 102,
                 bottom = 412;  // of the picture, of the plot in it [px]
constexpr double label_size = 11.5, text_size = svg_text_size, line_height = 17;  // [px]
constexpr double mark_radius = 5, ring_radius = 9.5;                              // [px]
constexpr std::size_t most_labels = 100, longest_name = 56, longest_path = 80;

/// Okabe and Ito's colours, which the colour-blind tell apart.
const char* colour_of(std::size_t level) {
    constexpr std::array colours{"#d55e00", "#0072b2", "#009e73"};
    return colours[level % colours.size()];
}

/// A shape of its own for each of three levels.
std::string outline_of(std::size_t level, PicturePoint at) {
    const std::array outlines{
        fmt::format("<path d=\"M{:.1f} {:.1f}l6 10.4h-12z\"", at.x, at.y - 6.6),
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"", at.x, at.y, mark_radius),
        fmt::format("<path d=\"M{:.1f} {:.1f}h9v9h-9z\"", at.x - 4.5, at.y - 4.5),
    };
    return outlines[level % outlines.size()];
}

std::string mark(std::size_t level, PicturePoint at, bool is_filled) {
    const char* colour = colour_of(level);
    return fmt::format("{} fill=\"{}\" stroke=\"{}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"/>",
                       outline_of(level, at), is_filled ? colour : "#ffffff", colour);
}

std::string ring(PicturePoint at) {
    return fmt::format(
        "<circle class=\"reference\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"none\" stroke=\"{}\" "
        "stroke-width=\"1.3\"/>\n",
        at.x, at.y, ring_radius, svg_dark);
}

/// `largest`: spacing of all [m].
std::string label_of(const TradeFacts& trade, const TradeFacts::Setting& setting, double largest) {
    if (setting.spacing <= 0) return trade.level_of(setting);
    const LengthUnit unit = length_unit(largest);
    return two_digits(setting.spacing / unit.metres) + " " + unit.name;
}

bool can_be_shown(const TradeFacts::Setting& setting) {
    return setting.is_candidate() && setting.cost > 0 && setting.error >= 0;  // NaN: no
}

/// The plot of a trade: axes, and where its settings are on them.
class Plot {
  public:
    explicit Plot(const TradeFacts& trade)
        : trade_(trade),
          largest_spacing_(trade.largest_spacing()),
          costs_(shown_costs(trade), left, right),
          errors_(shown_errors(trade), bottom, top) {
        for (std::size_t index = 0; index < trade.settings.size(); ++index)
            if (can_be_shown(trade.settings[index])) points_.push_back({index, place_of(trade.settings[index])});
    }

    [[nodiscard]] bool is_empty() const { return points_.empty(); }
    [[nodiscard]] bool has_level(std::size_t level) const {
        return std::ranges::any_of(points_, [&](const Point& each) { return setting(each).level == level; });
    }
    [[nodiscard]] bool has_reference() const {
        return std::ranges::any_of(points_, [&](auto& p) { return is_reference(p); });
    }
    [[nodiscard]] bool has_zero() const {
        return std::ranges::any_of(points_, [&](const Point& each) { return setting(each).error == 0; });
    }
    [[nodiscard]] bool has_labels() const { return points_.size() <= most_labels; }

    [[nodiscard]] std::string svg() const { return axes() + front_line() + labels() + marks(); }

  private:
    struct Point {
        std::size_t index;  ///< of the setting
        PicturePoint at;
    };

    static std::vector<double> shown_costs(const TradeFacts& trade) {
        std::vector<double> all;
        for (const TradeFacts::Setting& each : trade.settings)
            if (can_be_shown(each)) all.push_back(each.cost);
        return all;
    }
    static std::vector<double> shown_errors(const TradeFacts& trade) {
        std::vector<double> all(trade_tolerances.begin(), trade_tolerances.end());
        for (const TradeFacts::Setting& each : trade.settings)
            if (can_be_shown(each) && each.error > 0) all.push_back(each.error);
        return all;
    }

    [[nodiscard]] const TradeFacts::Setting& setting(const Point& point) const { return trade_.settings[point.index]; }
    [[nodiscard]] bool is_reference(const Point& point) const { return trade_.reference == point.index; }
    [[nodiscard]] PicturePoint place_of(const TradeFacts::Setting& of) const {
        return {costs_.at(of.cost), of.error > 0 ? errors_.at(of.error) : bottom};
    }

    [[nodiscard]] std::string axes() const {
        std::string all;
        for (const LogTick& tick : costs_.times(52)) {
            const double x = costs_.at_log10(tick.log10);
            all += svg_line({x, top}, {x, bottom}, svg_grid) + svg_line({x, bottom}, {x, bottom + 4}, svg_frame) +
                   svg_text({x, bottom + 18}, tick.text, SvgAlign::middle);
        }
        constexpr double apart = 16;
        std::vector<LogTick> ticks = errors_.percents(apart);
        for (const LogTick& tick : ticks) {
            const double y = errors_.at_log10(tick.log10);
            all += svg_line({left, y}, {right, y}, svg_grid);
        }
        for (const double tolerance : trade_tolerances) {
            const double y = errors_.at(tolerance);
            all += svg_line({left, y}, {right, y}, svg_frame, " class=\"tolerance\" stroke-dasharray=\"5 4\"");
            const auto is_near = [&](const LogTick& tick) {
                return std::abs(errors_.at_log10(tick.log10) - y) < apart;
            };
            if (std::ranges::none_of(ticks, is_near)) ticks.push_back({std::log10(tolerance), error_text(tolerance)});
        }
        for (const LogTick& tick : ticks) {
            const double y = errors_.at_log10(tick.log10);
            all +=
                svg_line({left - 4, y}, {left, y}, svg_frame) + svg_text({left - 8, y + 4.5}, tick.text, SvgAlign::end);
        }
        all += svg_line({left, top}, {left, bottom}, svg_frame) + svg_line({left, bottom}, {right, bottom}, svg_frame);
        all += svg_text({(left + right) / 2, bottom + 40}, "processor time", SvgAlign::middle);
        constexpr double middle = (top + bottom) / 2;
        return all + svg_text({14, middle}, "error", SvgAlign::middle,
                              fmt::format(" transform=\"rotate(-90 14 {:.1f})\"", middle));
    }

    [[nodiscard]] std::vector<PicturePoint> front_points() const {
        std::vector<PicturePoint> all;
        for (const std::size_t index : trade_.front)
            if (can_be_shown(trade_.settings[index])) all.push_back(place_of(trade_.settings[index]));
        return all;
    }
    [[nodiscard]] std::string front_line() const {
        std::string corners;
        for (const PicturePoint& at : front_points()) corners += fmt::format("{:.1f},{:.1f} ", at.x, at.y);
        return corners.empty() ? ""
                               : fmt::format(
                                     "<polyline class=\"front\" points=\"{}\" fill=\"none\" stroke=\"{}\" "
                                     "stroke-width=\"1.6\"/>\n",
                                     corners, svg_frame);
    }

    [[nodiscard]] std::string labels() const {
        if (!has_labels()) return "";
        LabelObstacles obstacles{{}, front_points(), {left + 2, top, right, bottom - 1}};
        std::vector<double> widths;
        for (const Point& each : points_) {
            const double radius = is_reference(each) ? ring_radius + 1 : mark_radius + 2;
            obstacles.marks.push_back({each.at.x - radius, each.at.y - radius, each.at.x + radius, each.at.y + radius});
            widths.push_back(svg_text_width(label_of(trade_, setting(each), largest_spacing_), label_size));
        }
        const std::vector<PictureBox> places = label_places(obstacles, widths, label_size + 2);
        std::string all;
        for (std::size_t k = 0; k < points_.size(); ++k) {
            const PictureBox& place = places[k];
            const PicturePoint at = points_[k].at;
            // To a label that is not beside its mark goes a line.
            const PicturePoint near{std::clamp(at.x, place.left, place.right),
                                    std::clamp(at.y, place.top, place.bottom)};
            if (std::hypot(near.x - at.x, near.y - at.y) > ring_radius + 6)
                all += svg_line(at, near, svg_frame, " stroke-width=\"0.8\"");
            // Fonts differ in width: the end that is at the mark stays there.
            const bool is_right = place.left > at.x, is_left = place.right < at.x;
            const SvgAlign align = is_right ? SvgAlign::start : is_left ? SvgAlign::end : SvgAlign::middle;
            const double x = is_right ? place.left : is_left ? place.right : place.centre().x;
            all += svg_text({x, place.bottom - 3}, label_of(trade_, setting(points_[k]), largest_spacing_), align,
                            fmt::format(" class=\"label\" font-size=\"{}\" fill=\"{}\" stroke=\"#ffffff\" "
                                        "stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                                        label_size, svg_dark));
        }
        return all;
    }

    [[nodiscard]] std::string marks() const {
        std::string all;
        for (const Point& each : points_) {
            const TradeFacts::Setting& of = setting(each);
            const std::string name =
                (of.spacing > 0 ? length_text(of.spacing, largest_spacing_) + ", " : "") + trade_.level_of(of);
            const std::string measure = of.error_is_of.empty() ? "" : " of " + of.error_is_of;
            all += fmt::format("<g class=\"mark\"><title>{}: {}, error {}{}</title>{}</g>\n", name,
                               wall_time_text(of.cost), error_text(of.error), escaped(shortened(measure, longest_path)),
                               mark(of.level, each.at, trade_.is_on_front(each.index)));
            if (is_reference(each)) all += ring(each.at);
        }
        return all;
    }

    const TradeFacts& trade_;
    double largest_spacing_;
    LogAxis costs_, errors_;
    std::vector<Point> points_;
};

/// What the marks mean, in a line, or in two where long names of levels take more than the picture's width.
std::string legend(const TradeFacts& trade, const Plot& plot) {
    constexpr double gap = 20, line_symbol = 28, mark_symbol = 17, ring_symbol = 25;
    const std::string of_front = "no other is cheaper and as good", of_reference = "reference";
    double levels_width = 0;
    for (std::size_t level = 0; level < trade.levels.size(); ++level)
        if (plot.has_level(level)) levels_width += mark_symbol + svg_text_width(trade.levels[level], text_size) + gap;
    double others_width = plot.is_empty() ? 0 : line_symbol + svg_text_width(of_front, text_size);
    if (plot.has_reference()) others_width += gap + ring_symbol + svg_text_width(of_reference, text_size);
    const bool has_two_lines = left + levels_width + others_width > width;

    double x = left, y = has_two_lines ? top - 36 : top - 24;
    std::string all;
    const auto add = [&](const std::string& symbol, double symbol_width, const std::string& words) {
        all += symbol + svg_text({x + symbol_width, y + 4.5}, words, SvgAlign::start);
        x += symbol_width + svg_text_width(words, text_size) + gap;
    };
    for (std::size_t level = 0; level < trade.levels.size(); ++level)
        if (plot.has_level(level)) add(mark(level, {x + 6, y}, true), mark_symbol, trade.levels[level]);
    if (plot.is_empty()) return all;
    if (has_two_lines) {
        x = left;
        y = top - 16;
    }
    add(svg_line({x, y}, {x + 22, y}, svg_frame, " stroke-width=\"1.6\"") +
            fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>", x + 11, y, svg_soft),
        line_symbol, of_front);
    if (plot.has_reference()) add(ring({x + 9, y}), ring_symbol, of_reference);
    return all;
}

std::vector<std::string> notes(const TradeFacts& trade, const Plot& plot) {
    std::vector<std::string> all;
    if (plot.has_zero()) all.emplace_back("At the lower edge: an error of 0.");
    if (!plot.has_labels()) all.emplace_back("Too many settings to label them.");
    const auto hidden =
        std::ranges::count_if(trade.settings, [](auto& each) { return each.is_candidate() && !can_be_shown(each); });
    if (hidden > 0)
        all.push_back(fmt::format("Not shown: {} setting{} without a processor time or an error.", hidden,
                                  hidden == 1 ? "" : "s"));
    for (const TradeFacts::Setting& each : trade.settings)
        if (each.is_reference_given)
            all.push_back("Compared with the run in " + shortened(each.run, longest_path) + ".");
    return all;
}

}  // namespace

std::string trade_picture(const TradeFacts& trade) {
    const Plot plot(trade);
    const std::vector<std::string> below = notes(trade, plot);
    const double height = bottom + 54 + (below.empty() ? 0 : 6 + line_height * static_cast<double>(below.size()));
    const std::string name = shortened(trade.name, longest_name);
    const std::string what = "error over processor time" +
                             (trade.simulated > 0 ? fmt::format(" of {:.4g} s simulated", trade.simulated) : "");
    std::string all = svg_text({left, 30}, name, SvgAlign::start,
                               fmt::format(" font-size=\"16\" font-weight=\"600\" fill=\"{}\"", svg_dark)) +
                      svg_text({left, 50}, what, SvgAlign::start);
    all += legend(trade, plot) + plot.svg();
    for (std::size_t k = 0; k < below.size(); ++k)
        all += svg_text({left, bottom + 62 + line_height * static_cast<double>(k)}, below[k], SvgAlign::start);
    return svg_picture(width, height, name + ": " + what, all);
}

void write_trade_picture(const std::filesystem::path& folder) {
    write_file(folder / trade_picture_name, trade_picture(read_trade_facts(folder / trade_file_name)));
}

}  // namespace dmp::report
