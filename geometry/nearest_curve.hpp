// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// CurveSet::nearest for many points of the x-y plane and distances up to a limit: the segments are sorted once into
/// the cells of a grid. The answers are the same, bit for bit. Holds its own copy of the curves; after construction it
/// is never changed, so any number of threads may ask it.
class NearestCurve {
  public:
    /// @param largest_distance how far to look [m]; must be positive (throws std::invalid_argument).
    NearestCurve(const CurveSet& curves, double largest_distance);

    /// The nearest point of the curves; nothing when all are further than the largest distance.
    [[nodiscard]] std::optional<Projection> nearest(const Vec& point) const;

    /// How many segments nearest() compares the point with.
    [[nodiscard]] std::size_t candidates(const Vec& point) const { return entries_near(point).size(); }

  private:
    struct Segment {
        Vec a, b;
    };

    /// The segments of the point's cell; none outside the box.
    [[nodiscard]] std::span<const std::size_t> entries_near(const Vec& point) const;
    [[nodiscard]] std::size_t column(double x) const;
    [[nodiscard]] std::size_t row(double y) const;

    double largest_distance_;
    Box box_;          ///< of the curves, widened by the largest distance
    double cell_ = 0;  ///< edge of a grid cell [m]
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<Segment> segments_;
    std::vector<std::size_t> begin_;    ///< cell -> its first entry in entries_; one more at the end
    std::vector<std::size_t> entries_;  ///< indices of segments, ascending in each cell
};

}  // namespace dmp::geometry
