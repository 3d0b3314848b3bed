// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_crossings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/exact_predicates.hpp"

namespace dmp {

namespace {

struct Found {
    std::size_t line;
    Crossing crossing;
};

/// A triangle seen along x: its corners in the plane of (y, z).
struct Shadow {
    std::array<Vec, 3> corner;

    /// Whether a ray from the point towards +y leaves it an odd number of times. Of the triangles that share an edge or
    /// a corner on which the point lies, it is one for each time that the surface passes there.
    [[nodiscard]] bool holds(const Vec& point) const {
        bool inside = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec& a = corner.at(k);
            const Vec& b = corner.at((k + 1) % 3);
            const Vec& low = a.y() <= b.y() ? a : b;
            const Vec& high = a.y() <= b.y() ? b : a;
            if (low.y() <= point.y() && point.y() < high.y() && side_of_line(low, high, point) > 0) inside = !inside;
        }
        return inside;
    }
};

/// One triangle and the lines that may meet it.
class Scan {
  public:
    Scan(const TriangleSurface& surface, int triangle) : number_(triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = static_cast<std::size_t>(surface.triangles[static_cast<std::size_t>(triangle)].at(k));
            corner_.at(k) = surface.corners[corner];
            shadow_.corner.at(k) = Vec(corner_.at(k).y(), corner_.at(k).z(), 0);
        }
        normal_ = (corner_[1] - corner_[0]).cross(corner_[2] - corner_[0]);
        // Of the same exact kind as the test whether a line is in the shadow.
        direction_ = -side_of_line(shadow_.corner[0], shadow_.corner[1], shadow_.corner[2]);
    }

    void look(const std::vector<LineRow>& rows, const std::vector<std::size_t>& first_line,
              std::vector<Found>& found) const {
        if (direction_ == 0) return;  // seen edge-on: its shadow holds no line
        const auto [low_z, high_z] = std::minmax({corner_[0].z(), corner_[1].z(), corner_[2].z()});
        const auto by_height = [](const LineRow& row, double z) { return row.z < z; };
        for (auto row = std::lower_bound(rows.begin(), rows.end(), low_z, by_height);
             row != rows.end() && row->z <= high_z; ++row) {
            const auto [low_y, high_y] = range_at(row->z);
            const int first = std::max(0, first_at_or_after(*row, low_y) - 1);
            for (int k = first; k < row->lines; ++k) {
                const double y = row->first_y + k * row->step_y;
                if (y > high_y) break;
                if (!shadow_.holds(Vec(y, row->z, 0))) continue;
                found.push_back({first_line[static_cast<std::size_t>(row - rows.begin())] + static_cast<std::size_t>(k),
                                 {x_at(y, row->z), number_, direction_}});
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
            const Vec& a = shadow_.corner.at(k);
            const Vec& b = shadow_.corner.at((k + 1) % 3);
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

    /// On the triangle's plane, but never beyond its corners.
    [[nodiscard]] double x_at(double y, double z) const {
        const auto [low, high] = std::minmax({corner_[0].x(), corner_[1].x(), corner_[2].x()});
        if (normal_.x() == 0) return 0.5 * (low + high);
        const Vec& a = corner_[0];
        const double x = a.x() - (normal_.y() * (y - a.y()) + normal_.z() * (z - a.z())) / normal_.x();
        return std::clamp(x, low, high);
    }

    int number_;
    std::array<Vec, 3> corner_;
    Shadow shadow_;
    Vec normal_;
    int direction_;
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

}  // namespace dmp
