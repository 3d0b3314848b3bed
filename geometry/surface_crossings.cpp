// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/triangle_along_x.hpp"

namespace dmp::geometry {

namespace {

struct Found {
    std::size_t line;
    Crossing crossing;
};

/// One triangle and the lines that may meet it.
class Scan {
  public:
    Scan(const TriangleSurface& surface, int triangle)
        : number_(triangle), triangle_(surface, static_cast<std::size_t>(triangle)) {}

    void look(const std::vector<LineRow>& rows, const std::vector<std::size_t>& first_line,
              std::vector<Found>& found) const {
        if (triangle_.direction() == 0) return;
        const auto& [a, b, c] = triangle_.shadow();
        const auto [low_z, high_z] = std::minmax({a.y(), b.y(), c.y()});
        const auto by_height = [](const LineRow& row, double z) { return row.z < z; };
        for (auto row = std::lower_bound(rows.begin(), rows.end(), low_z, by_height);
             row != rows.end() && row->z <= high_z; ++row) {
            const auto [low_y, high_y] = range_at(row->z);
            const int first = std::max(0, first_at_or_after(*row, low_y) - 1);
            for (int k = first; k < row->lines; ++k) {
                const double y = row->first_y + k * row->step_y;
                if (y > high_y) break;
                if (!triangle_.meets(y, row->z)) continue;
                found.push_back({first_line[static_cast<std::size_t>(row - rows.begin())] + static_cast<std::size_t>(k),
                                 {triangle_.x_at(y, row->z), number_, triangle_.direction()}});
            }
        }
    }

  private:
    static int first_at_or_after(const LineRow& row, double y) {
        const double k = std::ceil((y - row.first_y) / row.step_y);
        return static_cast<int>(std::clamp(k, 0.0, static_cast<double>(row.lines)));
    }

    /// Of y where the triangle's shadow has this z; a little wider than exact.
    [[nodiscard]] std::pair<double, double> range_at(double z) const {
        double low = HUGE_VAL, high = -HUGE_VAL, scale = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec& a = triangle_.shadow().at(k);
            const Vec& b = triangle_.shadow().at((k + 1) % 3);
            scale = std::max(scale, std::abs(a.x()));
            if (std::min(a.y(), b.y()) > z || std::max(a.y(), b.y()) < z) continue;
            const double part = a.y() == b.y() ? 0 : std::clamp((z - a.y()) / (b.y() - a.y()), 0.0, 1.0);
            for (const double y :
                 {a.x() + part * (b.x() - a.x()), a.y() == b.y() ? b.x() : a.x() + part * (b.x() - a.x())}) {
                low = std::min(low, y);
                high = std::max(high, y);
            }
        }
        return {low - 1e-12 * scale, high + 1e-12 * scale};
    }

    int number_;
    TriangleAlongX triangle_;
};

}  // namespace

SurfaceCrossings::SurfaceCrossings(const TriangleSurface& surface, const std::vector<LineRow>& rows, int threads) {
    std::size_t lines = 0;
    for (const LineRow& row : rows) {
        first_line_.push_back(lines);
        lines += static_cast<std::size_t>(row.lines);
    }
    const auto triangles = static_cast<int>(surface.triangles.size());
    std::vector<std::vector<Found>> found(static_cast<std::size_t>(threads));
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int share = 0; share < threads; ++share) {
        const auto part = [&](int k) { return static_cast<int>(static_cast<long>(triangles) * k / threads); };
        for (int t = part(share); t < part(share + 1); ++t)
            Scan(surface, t).look(rows, first_line_, found[static_cast<std::size_t>(share)]);
    }
    begin_.assign(lines + 1, 0);
    for (const auto& some : found)
        for (const Found& one : some) ++begin_[one.line + 1];
    for (std::size_t line = 0; line < lines; ++line) begin_[line + 1] += begin_[line];
    crossings_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (auto& some : found) {
        for (const Found& one : some) crossings_[next[one.line]++] = one.crossing;
        some = {};
    }
    for (std::size_t line = 0; line < lines; ++line) {
        const auto first = crossings_.begin() + static_cast<std::ptrdiff_t>(begin_[line]);
        const auto last = crossings_.begin() + static_cast<std::ptrdiff_t>(begin_[line + 1]);
        // Where a surface turns back at one x, what goes in comes first.
        std::sort(first, last, [](const Crossing& a, const Crossing& b) {
            return a.x != b.x                   ? a.x < b.x
                   : a.direction != b.direction ? a.direction > b.direction
                                                : a.triangle < b.triangle;
        });
        int sum = 0;
        for (auto crossing = first; crossing != last; ++crossing) sum += crossing->direction;
        unbalanced_ += sum != 0 ? 1 : 0;
    }
}

}  // namespace dmp::geometry
