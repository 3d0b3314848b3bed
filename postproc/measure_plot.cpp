// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/measure_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "postproc/axis.hpp"

namespace dmp::postproc {

namespace {

constexpr Colour curve{31, 90, 166};

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// Adds a margin above and below; a constant gets a range in which it appears constant.
    void widen(double share) {
        if (low > high) low = 0, high = 1;
        double air = share * (high - low);
        if (high - low <= 1e-12 * std::max(std::abs(low), std::abs(high))) air = low == 0 ? 1 : 0.05 * std::abs(low);
        low -= air;
        high += air;
    }
};

/// Position of a panel's curve on the sheet [pixels].
struct Frame2d {
    double left, top, width, height;
};

class Panel {
  public:
    Panel(Canvas& canvas, Frame2d position, Range time, Range value, double unit)
        : canvas_(canvas), position_(position), time_(time), value_(value), unit_(unit) {}

    void draw_axes(const std::string& label, bool with_time) const {
        const Ticks times = round_ticks(time_.low, time_.high, 10);
        const Ticks values = round_ticks(value_.low, value_.high, 4);
        for (const double t : times.value)
            canvas_.fill(x(t), position_.top, std::max(1.0, unit_), position_.height, colours::grid);
        for (const double v : values.value)
            canvas_.fill(position_.left, y(v), position_.width, std::max(1.0, unit_), colours::grid);
        const Canvas::TextStyle right{20 * unit_, Align::right};
        const Canvas::TextStyle centre{20 * unit_, Align::centre};
        for (std::size_t i = 0; i < values.value.size(); ++i)
            canvas_.text(position_.left - 10 * unit_, y(values.value[i]), values.text[i], right);
        if (with_time)
            for (std::size_t i = 0; i < times.value.size(); ++i)
                canvas_.text(x(times.value[i]), bottom() + 18 * unit_, times.text[i], centre);
        canvas_.text(position_.left, position_.top - 18 * unit_, label, {22 * unit_, Align::left, true});
    }

    void draw_curve(const MeasureSeries& measures, std::size_t column) const {
        std::vector<std::array<double, 2>> piece;
        const auto finish = [&] {
            const double thickness = piece.size() == 1 ? 7 * unit_ : 2.6 * unit_;
            canvas_.line(piece, curve, thickness);
            piece.clear();
        };
        for (std::size_t i = 0; i < measures.rows.size(); ++i) {
            const double value = measures.rows[i][column];
            if (std::isfinite(value))
                piece.push_back({x(measures.time[i]), y(value)});
            else
                finish();
        }
        finish();
    }

    void draw_outline() const {
        const double thin = std::max(1.0, 1.5 * unit_);
        canvas_.fill(position_.left, position_.top, thin, position_.height, colours::frame);
        canvas_.fill(position_.left, bottom(), position_.width, thin, colours::frame);
    }

  private:
    [[nodiscard]] double bottom() const { return position_.top + position_.height; }
    [[nodiscard]] double x(double time) const {
        return position_.left + position_.width * (time - time_.low) / (time_.high - time_.low);
    }
    [[nodiscard]] double y(double value) const {
        return bottom() - position_.height * (value - value_.low) / (value_.high - value_.low);
    }

    Canvas& canvas_;
    Frame2d position_;
    Range time_, value_;
    double unit_;
};

}  // namespace

Canvas draw_measures(const MeasureSeries& measures, const std::string& title, int width) {
    const auto count = static_cast<double>(measures.names.size());
    const double unit = std::min(width / 1600.0, Canvas::largest / (174 + 300 * count));
    width = static_cast<int>(std::lround(1600 * unit));
    const double head = title.empty() ? 24 * unit : 84 * unit;
    const double pitch = 300 * unit;
    const double foot = 90 * unit;
    Canvas canvas(width, static_cast<int>(std::lround(head + pitch * count + foot)));
    canvas.text_within(width - 80 * unit, 40 * unit, 48 * unit, title, {30 * unit, Align::left, true});

    Range time;
    for (const double t : measures.time) time.include(t);
    time.widen(0);
    for (std::size_t column = 0; column < measures.names.size(); ++column) {
        Range value;
        for (const auto& row : measures.rows) value.include(row[column]);
        value.widen(0.08);
        const double top = head + pitch * static_cast<double>(column) + 40 * unit;
        const Frame2d position{140 * unit, top, width - 190 * unit, pitch - 76 * unit};
        const Panel panel(canvas, position, time, value, unit);
        const bool last = column + 1 == measures.names.size();
        panel.draw_axes(axis_label(measures.names[column], measures.units[column]), last);
        panel.draw_curve(measures, column);
        panel.draw_outline();
    }
    canvas.text(140 * unit + (width - 190 * unit) / 2, head + pitch * count + 38 * unit, "time [s]",
                {22 * unit, Align::centre});
    return canvas;
}

}  // namespace dmp::postproc
