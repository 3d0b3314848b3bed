// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// Region::side_of for many points: the boundary segments are sorted once into horizontal bands, so that a point meets
/// only those of its own band. The answers are the same, exact ones. Holds its own copy of the boundary; after
/// construction it is never changed, so any number of threads may ask it.
class InsideTest {
  public:
    explicit InsideTest(const Region& region);

    [[nodiscard]] Side side_of(const Vec& point) const;

    /// How many segments side_of() compares the point with, unless it finds it on one of them.
    [[nodiscard]] std::size_t candidates(const Vec& point) const { return segments_near(point).size(); }

  private:
    struct Segment {
        Vec a, b;
    };

    /// The segments of the point's band; none above and below all of them.
    [[nodiscard]] std::span<const Segment> segments_near(const Vec& point) const;
    [[nodiscard]] std::size_t band_of(double y) const;

    double low_, high_;               ///< range of the boundary in y [m]
    double bands_per_length_ = 0;     ///< [1/m]
    std::vector<std::size_t> begin_;  ///< band -> its first entry in segments_; one more at the end
    std::vector<Segment> segments_;   ///< band after band
};

}  // namespace dmp::geometry
