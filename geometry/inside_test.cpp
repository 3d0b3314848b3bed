// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/inside_test.hpp"

#include <algorithm>
#include <limits>

#include "geometry/exact_predicates.hpp"
#include "geometry/segments.hpp"

namespace dmp::geometry {

namespace {

constexpr std::size_t most_bands = 4096;  // a tall segment lies in all of them

}  // namespace

InsideTest::InsideTest(const Region& region) : low_(std::numeric_limits<double>::infinity()), high_(-low_) {
    std::vector<Segment> all;
    for_each_segment(region, [&](const Vec& a, const Vec& b) {
        all.push_back({a, b});
        low_ = std::min(low_, a.y());
        high_ = std::max(high_, a.y());
    });
    const std::size_t bands = std::clamp<std::size_t>(all.size(), 1, most_bands);
    bands_per_length_ = high_ > low_ ? static_cast<double>(bands) / (high_ - low_) : 0.0;

    const auto for_each_band = [&](const Segment& segment, auto&& visit) {
        const auto [bottom, top] = std::minmax(segment.a.y(), segment.b.y());
        for (std::size_t band = band_of(bottom); band <= band_of(top); ++band) visit(band);
    };
    begin_.assign(most_bands + 1, 0);
    for (const auto& segment : all) for_each_band(segment, [&](std::size_t band) { ++begin_[band + 1]; });
    for (std::size_t band = 0; band < most_bands; ++band) begin_[band + 1] += begin_[band];
    segments_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const auto& segment : all) {
        for_each_band(segment, [&](std::size_t band) { segments_[next[band]++] = segment; });
    }
}

std::size_t InsideTest::band_of(double y) const {
    // Rounding keeps order, so a point level with a segment always finds it in its band.
    return std::min(static_cast<std::size_t>((y - low_) * bands_per_length_), most_bands - 1);
}

std::span<const InsideTest::Segment> InsideTest::segments_near(const Vec& point) const {
    if (!(point.y() >= low_ && point.y() <= high_)) return {};
    const std::size_t band = band_of(point.y());
    return std::span(segments_).subspan(begin_[band], begin_[band + 1] - begin_[band]);
}

Side InsideTest::side_of(const Vec& point) const {
    bool inside = false;
    for (const auto& [a, b] : segments_near(point)) {
        const RayMeeting meeting = meet_ray(point, a, b);
        if (meeting == RayMeeting::starts_on) return Side::on_edge;
        inside = inside != (meeting == RayMeeting::crosses);
    }
    return inside ? Side::inside : Side::outside;
}

}  // namespace dmp::geometry
