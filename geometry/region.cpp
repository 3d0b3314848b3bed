// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "geometry/exact_predicates.hpp"
#include "geometry/geometry.hpp"
#include "geometry/segments.hpp"

namespace dmp::geometry {

namespace {

/// A boundary segment that rises from low to high.
struct RisingSegment {
    Vec low, high;

    [[nodiscard]] double x_at(double y) const {
        if (y == low.y()) return low.x();
        if (y == high.y()) return high.x();
        return low.x() + (high.x() - low.x()) * ((y - low.y()) / (high.y() - low.y()));
    }
};

}  // namespace

/// Cuts the region into horizontal bands between neighbouring vertices, each a row of trapezoids that are in turn
/// inside and outside. Unlike the shoelace formula it needs neither the loops' direction nor which loop lies in which.
double Region::area() const {
    std::vector<RisingSegment> segments;
    std::vector<double> levels;
    for_each_segment(*this, [&](const Vec& a, const Vec& b) {
        levels.push_back(a.y());
        if (a.y() < b.y()) segments.push_back({a, b});
        if (b.y() < a.y()) segments.push_back({b, a});
    });
    std::ranges::sort(levels);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    std::ranges::sort(segments, {}, [](const RisingSegment& s) { return s.low.y(); });

    struct Flank {
        double bottom, top;  // x at the band's two edges
    };
    double sum = 0;
    std::vector<const RisingSegment*> active;
    std::vector<Flank> flanks;
    auto next = segments.cbegin();
    for (std::size_t band = 0; band + 1 < levels.size(); ++band) {
        const double bottom = levels[band];
        const double top = levels[band + 1];
        std::erase_if(active, [&](const RisingSegment* s) { return s->high.y() <= bottom; });
        for (; next != segments.cend() && next->low.y() <= bottom; ++next) active.push_back(&*next);
        flanks.clear();
        for (const auto* segment : active) flanks.push_back({segment->x_at(bottom), segment->x_at(top)});
        std::ranges::sort(flanks, {}, [](const Flank& flank) { return flank.bottom + flank.top; });
        for (std::size_t i = 0; i + 1 < flanks.size(); i += 2) {
            const double widths = (flanks[i + 1].bottom - flanks[i].bottom) + (flanks[i + 1].top - flanks[i].top);
            sum += 0.5 * widths * (top - bottom);
        }
    }
    return sum;
}

Side Region::side_of(const Vec& point) const {
    bool inside = false;
    bool on_edge = false;
    for_each_segment(*this, [&](const Vec& a, const Vec& b) {
        const RayMeeting meeting = meet_ray(point, a, b);
        on_edge = on_edge || meeting == RayMeeting::starts_on;
        inside = inside != (meeting == RayMeeting::crosses);
    });
    if (on_edge) return Side::on_edge;
    return inside ? Side::inside : Side::outside;
}

}  // namespace dmp::geometry
