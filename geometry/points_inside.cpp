// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/points_inside.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/triangle_along_x.hpp"

namespace dmp::geometry {

namespace {

/// Points sorted into the cells of a grid over (y, z), about two of them in each.
class PointsAlongX {
  public:
    explicit PointsAlongX(const std::vector<Vec>& points) : low_(points.front()), high_(points.front()) {
        for (const Vec& point : points) {
            low_ = low_.cwiseMin(point);
            high_ = high_.cwiseMax(point);
        }
        const double wanted = std::max(1.0, 0.5 * static_cast<double>(points.size()));
        const double width = high_.y() - low_.y(), height = high_.z() - low_.z();
        // Square cells, but no more along an axis than are wanted in all: the points may lie on a line.
        const double size = std::max({std::sqrt(width * height / wanted), width / wanted, height / wanted});
        if (size > 0) {
            cells_per_length_ = 1 / size;
            columns_ = cell(width) + 1;
            rows_ = cell(height) + 1;
        }
        std::vector<std::size_t> cell_of(points.size());
        begin_.assign(columns_ * rows_ + 1, 0);
        for (std::size_t k = 0; k < points.size(); ++k) {
            cell_of[k] = row(points[k].z()) * columns_ + column(points[k].y());
            ++begin_[cell_of[k] + 1];
        }
        for (std::size_t c = 0; c + 1 < begin_.size(); ++c) begin_[c + 1] += begin_[c];
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        sorted_.resize(points.size());
        for (std::size_t k = 0; k < points.size(); ++k) sorted_[next[cell_of[k]]++] = k;
    }

    /// Calls visit(k) for all points whose y and z may lie within these bounds.
    template <class Visit>
    void for_each_within(double low_y, double high_y, double low_z, double high_z, Visit&& visit) const {
        if (low_y > high_.y() || high_y < low_.y() || low_z > high_.z() || high_z < low_.z()) return;
        const std::size_t first = column(low_y), last = column(high_y), last_row = row(high_z);
        for (std::size_t r = row(low_z); r <= last_row; ++r) {
            const std::size_t from = begin_[r * columns_ + first], to = begin_[r * columns_ + last + 1];
            for (const std::size_t k : std::span(sorted_).subspan(from, to - from)) visit(k);
        }
    }

  private:
    [[nodiscard]] std::size_t cell(double distance) const {
        return static_cast<std::size_t>(std::max(distance, 0.0) * cells_per_length_);
    }
    [[nodiscard]] std::size_t column(double y) const { return std::min(cell(y - low_.y()), columns_ - 1); }
    [[nodiscard]] std::size_t row(double z) const { return std::min(cell(z - low_.z()), rows_ - 1); }

    Vec low_, high_;
    double cells_per_length_ = 0;  ///< [1/m]
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<std::size_t> begin_;   ///< cell -> its first entry in sorted_; one more at the end
    std::vector<std::size_t> sorted_;  ///< numbers of points, cell after cell
};

}  // namespace

std::vector<bool> points_inside(const TriangleSurface& surface, const std::vector<Vec>& points) {
    std::vector<bool> inside(points.size());
    if (points.empty()) return inside;
    const PointsAlongX sorted(points);
    std::vector<int> depth(points.size(), 0);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const TriangleAlongX triangle(surface, t);
        if (triangle.direction() == 0) continue;
        const auto& [a, b, c] = triangle.shadow();
        const auto [low_y, high_y] = std::minmax({a.x(), b.x(), c.x()});
        const auto [low_z, high_z] = std::minmax({a.y(), b.y(), c.y()});
        sorted.for_each_within(low_y, high_y, low_z, high_z, [&](std::size_t k) {
            const Vec& point = points[k];
            if (triangle.meets(point.y(), point.z()) && triangle.x_at(point.y(), point.z()) <= point.x())
                depth[k] += triangle.direction();
        });
    }
    for (std::size_t k = 0; k < points.size(); ++k) inside[k] = depth[k] > 0;
    return inside;
}

}  // namespace dmp::geometry
