// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A row of lines parallel to x, at one z and at y = first_y + k step_y, k in [0, lines).
struct LineRow {
    double z = 0;        ///< [m]
    double first_y = 0;  ///< [m]
    double step_y = 0;   ///< above 0 [m]
    int lines = 0;
};

/// Where a line parallel to x passes through a surface.
struct Crossing {
    double x = 0;       ///< [m]
    int triangle = 0;   ///< index into TriangleSurface::triangles
    int direction = 0;  ///< +1: into what the surface encloses, as x grows; -1: out of it
};

/// Where many lines parallel to x pass through a surface: the scanlines of a solid's fill. Each line meets each closed
/// surface in an even number of crossings, also where it runs through edges and corners: a line on the common edge of
/// two triangles, seen along x, belongs to exactly one of them, decided with exact predicates (the half-open rule of
/// filled polygons).
class SurfaceCrossings {
  public:
    /// Rows in ascending order of z. Time grows with the number of triangles and of crossings.
    SurfaceCrossings(const TriangleSurface& surface, const std::vector<LineRow>& rows, int threads = 1);

    /// Those of one line, by ascending x.
    [[nodiscard]] std::span<const Crossing> of(std::size_t row, int line) const {
        const std::size_t at = first_line_[row] + static_cast<std::size_t>(line);
        return {crossings_.data() + begin_[at], begin_[at + 1] - begin_[at]};
    }
    /// Lines on which the directions do not add up to zero: the surface is open there, or its triangles face both ways.
    [[nodiscard]] std::size_t unbalanced() const { return unbalanced_; }

  private:
    std::vector<std::size_t> first_line_;  ///< by row: the number of its first line
    std::vector<std::size_t> begin_;       ///< by line: its first crossing; one more at the end
    std::vector<Crossing> crossings_;
    std::size_t unbalanced_ = 0;
};

}  // namespace dmp::geometry
