// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/panel_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dmp::postproc {

namespace {

// in panel widths
constexpr double relative_gap = 0.03;
constexpr double caption_room = 0.03;
constexpr double letter_width = 0.009;     // average, in a caption
constexpr double assumed_height = 0.7;     // used to choose the rows; a single tall picture may be taller
constexpr double magnified_height = 0.45;  // of a magnified row
constexpr double worth_a_row = 1.3;        // minimum enlargement that justifies one more row

constexpr std::array magnifications{10.0, 5.0, 4.0, 3.0, 2.0};

}  // namespace

struct PanelLayout::Rows {
    std::vector<Slot> positions;
    std::vector<double> magnification;
    double width = 0, height = 0, caption_height = 0;
    int count = 0;

    /// Pixels per metre on a panel one pixel wide, as the geometric mean for the first picture and for all pictures,
    /// with a penalty for each additional row.
    [[nodiscard]] double merit() const {
        const double mean = std::accumulate(magnification.begin(), magnification.end(), 0.0) /
                            static_cast<double>(magnification.size());
        return std::sqrt(mean) * std::min(1 / width, assumed_height / height) / std::pow(worth_a_row, count - 1);
    }
};

PanelLayout::PanelLayout(std::vector<PanelActors> drawings) : panels_(std::move(drawings)) {
    Rows best = in_rows(0);
    for (unsigned breaks = 1; breaks < 1U << (panels_.size() - 1); ++breaks)
        if (Rows rows = in_rows(breaks); rows.merit() > best.merit() * (1 + 1e-9)) best = std::move(rows);
    positions_ = std::move(best.positions);
    width_ = best.width;
    height_ = best.height;
    caption_height_ = best.caption_height;
    for (std::size_t k = 0; k < panels_.size(); ++k)
        if (const auto times = std::lround(best.magnification[k]); times > 1)
            panels_[k].caption += ", " + std::to_string(times) + " : 1";
}

/// The bits of `breaks` mark the pictures after which a new row begins.
PanelLayout::Rows PanelLayout::in_rows(unsigned breaks) const {
    struct Row {
        std::size_t first = 0, last = 0;
        double height = 0;
    };
    std::vector<Row> rows;
    for (std::size_t k = 0; k < panels_.size(); ++k) {
        if (k == 0 || (breaks >> (k - 1) & 1U) != 0) rows.push_back({k, k, 0});
        Row& row = rows.back();
        row.last = k;
        row.height = std::max(row.height, panels_[k].area.extent().y());
    }
    Rows result;
    for (const Row& row : rows) result.width = std::max(result.width, least_width(row.first, row.last));
    const bool captions = std::ranges::any_of(panels_, [](const PanelActors& d) { return !d.caption.empty(); });
    result.caption_height = captions ? caption_room * result.width : 0;
    result.count = static_cast<int>(rows.size());
    result.positions.resize(panels_.size());
    result.magnification.assign(panels_.size(), 1);
    for (const Row& row : rows) {
        const auto fits = [&](double times) {
            if (times * row.height > magnified_height * result.width) return false;
            double width = relative_gap * result.width * static_cast<double>(row.last - row.first);
            for (std::size_t k = row.first; k <= row.last; ++k) width += room_of(k, times, result.width);
            return width <= result.width * (1 + 1e-9);
        };
        double times = 1;
        if (row.first > 0 && captions)
            if (const auto* largest = std::ranges::find_if(magnifications, fits); largest != magnifications.end())
                times = *largest;
        if (row.first > 0) result.height += relative_gap * result.width;
        double x = 0;
        for (std::size_t k = row.first; k <= row.last; ++k) {
            const Vec size = times * panels_[k].area.extent();
            result.positions[k] = {x, result.height + result.caption_height, size.x(), size.y()};
            result.magnification[k] = times;
            x += room_of(k, times, result.width) + relative_gap * result.width;
        }
        result.height += result.caption_height + times * row.height;
    }
    return result;
}

/// The width of a picture with its caption on a panel of the given width.
double PanelLayout::room_of(std::size_t k, double times, double panel_width) const {
    const double caption = letter_width * panel_width * static_cast<double>(panels_[k].caption.size());
    return std::max(times * panels_[k].area.extent().x(), caption);
}

/// The smallest width of a panel on which these pictures fit side by side.
double PanelLayout::least_width(std::size_t first, std::size_t last) const {
    double width = 0;
    for (std::size_t k = first; k <= last; ++k) width += panels_[k].area.extent().x();
    // captions take a fraction of the width: widen the panel until everything fits
    for (int k = 0; k < 100; ++k) {
        double taken = relative_gap * width * static_cast<double>(last - first);
        for (std::size_t d = first; d <= last; ++d) taken += room_of(d, 1, width);
        if (taken <= width) break;
        width *= 1.02;
    }
    return width;
}

Box PanelLayout::area() const { return {Vec::Zero(), Vec(width_, height_, 0)}; }

Image PanelLayout::draw(int panel_width, int panel_height, const Draw& draw) const {
    Canvas panel(panel_width, panel_height);
    const double scale = std::min(panel_width / width_, panel_height / height_);
    const auto pixels = [scale](double length) { return std::max(1, static_cast<int>(std::lround(scale * length))); };
    // the same size for all captions: the largest at which none is wider than its picture
    Canvas::TextStyle style{0.5 * scale * caption_height_, Align::left};
    const double full_size = style.size;
    for (std::size_t k = 0; k < panels_.size(); ++k)
        if (const std::string& caption = panels_[k].caption; !caption.empty())
            style.size = std::min(style.size, full_size * scale * positions_[k].width /
                                                  Canvas::text_width(caption, {full_size, Align::left}));
    for (std::size_t k = 0; k < panels_.size(); ++k) {
        const Slot& position = positions_[k];
        const int width = std::min(pixels(position.width), panel_width);
        const int height = std::min(pixels(position.height), panel_height);
        const double x = scale * position.x, y = scale * position.y;
        panel.paste(draw(k, width, height), static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)));
        if (!panels_[k].caption.empty()) panel.text(x, y - full_size, panels_[k].caption, style);
    }
    return panel.image();
}

}  // namespace dmp::postproc
