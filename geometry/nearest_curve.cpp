// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/segments.hpp"

namespace dmp::geometry {

namespace {

constexpr double most_cells = 1 << 18;

std::size_t cell_index(double position, double low, double cell, std::size_t count) {
    const double index = (position - low) / cell;
    return index <= 0 ? 0 : std::min(static_cast<std::size_t>(index), count - 1);
}

}  // namespace

NearestCurve::NearestCurve(const CurveSet& curves, double largest_distance) : largest_distance_(largest_distance) {
    if (!(largest_distance > 0)) throw std::invalid_argument("NearestCurve: the largest distance must be positive");
    for (const auto& piece : curves.pieces) {
        if (piece.points.size() == 1) segments_.push_back({piece.points[0], piece.points[0]});
        for_each_segment(piece, [&](const Vec& a, const Vec& b) { segments_.push_back({a, b}); });
    }
    if (segments_.empty()) return;

    box_ = {.low = segments_[0].a, .high = segments_[0].a};
    for (const auto& segment : segments_) {
        box_.low = box_.low.cwiseMin(segment.a.cwiseMin(segment.b));
        box_.high = box_.high.cwiseMax(segment.a.cwiseMax(segment.b));
    }
    // Slightly more than asked for: rounding may not push a segment out of a point's cell.
    const double reach = largest_distance * (1 + 1e-9) + 1e-14 * box_.extent().norm();
    box_.low -= Vec::Constant(reach);
    box_.high += Vec::Constant(reach);
    const Vec extent = box_.extent();
    cell_ = std::max(largest_distance, std::sqrt(extent.x() * extent.y() / most_cells));
    columns_ = static_cast<std::size_t>(extent.x() / cell_) + 1;
    rows_ = static_cast<std::size_t>(extent.y() / cell_) + 1;

    // Long segments are cut for the sorting, so that an oblique one does not fill its whole box.
    std::vector<std::pair<std::size_t, std::size_t>> found;  // cell, segment
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const auto& [a, b] = segments_[i];
        const auto cuts = static_cast<std::size_t>((b - a).norm() / cell_) + 1;
        for (std::size_t cut = 0; cut < cuts; ++cut) {
            const Vec from = a + (b - a) * (static_cast<double>(cut) / static_cast<double>(cuts));
            const Vec to = a + (b - a) * (static_cast<double>(cut + 1) / static_cast<double>(cuts));
            const Vec low = from.cwiseMin(to) - Vec::Constant(reach);
            const Vec high = from.cwiseMax(to) + Vec::Constant(reach);
            for (std::size_t y = row(low.y()); y <= row(high.y()); ++y) {
                for (std::size_t x = column(low.x()); x <= column(high.x()); ++x)
                    found.emplace_back(y * columns_ + x, i);
            }
        }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    begin_.assign(columns_ * rows_ + 1, 0);
    for (const auto& [cell, segment] : found) {
        ++begin_[cell + 1];
        entries_.push_back(segment);
    }
    for (std::size_t cell = 0; cell + 1 < begin_.size(); ++cell) begin_[cell + 1] += begin_[cell];
}

std::size_t NearestCurve::column(double x) const { return cell_index(x, box_.low.x(), cell_, columns_); }
std::size_t NearestCurve::row(double y) const { return cell_index(y, box_.low.y(), cell_, rows_); }

std::span<const std::size_t> NearestCurve::entries_near(const Vec& point) const {
    if (segments_.empty()) return {};
    const bool in_box = point.x() >= box_.low.x() && point.x() <= box_.high.x() && point.y() >= box_.low.y() &&
                        point.y() <= box_.high.y();
    if (!in_box) return {};
    const std::size_t cell = row(point.y()) * columns_ + column(point.x());
    return std::span(entries_).subspan(begin_[cell], begin_[cell + 1] - begin_[cell]);
}

std::optional<Projection> NearestCurve::nearest(const Vec& point) const {
    Projection best{.distance = std::numeric_limits<double>::infinity()};
    for (const std::size_t entry : entries_near(point)) {
        const auto& [a, b] = segments_[entry];
        keep_nearest(best, point, a, b);
    }
    if (!(best.distance <= largest_distance_)) return std::nullopt;
    return best;
}

}  // namespace dmp::geometry
