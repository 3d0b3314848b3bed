// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plane_guess.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "cli/first_guess.hpp"
#include "cli/uses.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/local_thickness.hpp"
#include "geometry/nearest_curve.hpp"
#include "geometry/segments.hpp"
#include "geometry/select_faces.hpp"
#include "geometry/standing_strips.hpp"

namespace dmp::cli {

namespace {

/// Relative to the geometry's size: how far beside a curve is looked for fluid, how far a point may be from a side of
/// the box that it lies on, and from a curve that was drawn as chords.
constexpr double beside = 1e-5, on_side = 1e-5, on_curve = 2e-3;

struct Segment {
    Vec a, b;
    [[nodiscard]] Vec middle() const { return 0.5 * (a + b); }
    [[nodiscard]] double length() const { return (b - a).norm(); }
    [[nodiscard]] Vec left() const { return Vec(a.y() - b.y(), b.x() - a.x(), 0).normalized(); }
};

/// Where on a side of the box, from and to along the other axis.
using Intervals = std::vector<std::pair<double, double>>;

Intervals joined(Intervals intervals, double tolerance) {
    std::ranges::sort(intervals);
    Intervals all;
    for (const auto& [from, to] : intervals)
        if (!all.empty() && from <= all.back().second + tolerance)
            all.back().second = std::max(all.back().second, to);
        else
            all.emplace_back(from, to);
    return all;
}

bool alike(const Intervals& one, const Intervals& other, double tolerance) {
    return !one.empty() && std::ranges::equal(one, other, [&](const auto& a, const auto& b) {
        return std::abs(a.first - b.first) <= tolerance && std::abs(a.second - b.second) <= tolerance;
    });
}

/// The edges' median distance from what is opposite, measured along strips that stand on them.
double usual_distance(const std::vector<Segment>& edges, double size) {
    if (edges.empty()) return 0;
    const double step = size / 200;
    std::vector<PlaneSegment> segments;
    for (const Segment& edge : edges) segments.push_back({edge.a, edge.b});
    const TriangleSurface strips = standing_strips(segments, step);
    LocalThickness found = local_thickness(strips, step);
    std::ranges::sort(found.samples, {}, &ThicknessSample::thickness);
    double all = 0, passed = 0;
    for (const ThicknessSample& sample : found.samples) all += sample.area;
    for (const ThicknessSample& sample : found.samples) {
        passed += sample.area;
        if (2 * passed >= all) return sample.thickness;
    }
    return 0;
}

class Look {
  public:
    explicit Look(const Geometry& geometry) : geometry_(geometry) {
        PlaneGuess& guess = guess_;
        guess.box.low.setConstant(std::numeric_limits<double>::infinity());
        guess.box.high = -guess.box.low;
        for (const Region& region : geometry.regions) {
            fluids_.emplace_back(region);
            guess.area += region.area();
            for_each_segment(region, [&](const Vec& a, const Vec& /*b*/) {
                guess.box.low = guess.box.low.cwiseMin(a);
                guess.box.high = guess.box.high.cwiseMax(a);
            });
        }
        size_ = guess.box.extent().norm();
    }

    PlaneGuess guess() {
        for (const CurveSet& set : geometry_.curves) guess_.curves.push_back(look_at(set));
        find_edges();
        find_periods();
        find_walls();
        selected_ = geometry_;
        select_faces(selected_, guess_.caps);
        select_faces(selected_, guess_.walls);
        guess_.across = usual_distance(walls_, size_);
        if (!(guess_.across > 0)) guess_.across = std::min(guess_.box.extent().x(), guess_.box.extent().y());
        for (CurveGuess& curve : guess_.curves)
            if (curve.role == CurveRole::flexible) inspect_ends(curve);
        return std::move(guess_);
    }

  private:
    /// An edge of the fluid: of which area, and by which named curves.
    struct Edge {
        Segment segment;
        const Region* of;
        std::vector<std::size_t> names;
        int side = -1;  ///< 2 axis, and 1 more on the high side; -1: on none
    };

    [[nodiscard]] bool is_fluid(const Vec& position) const {
        return std::ranges::any_of(fluids_,
                                   [&](const InsideTest& fluid) { return fluid.side_of(position) == Side::inside; });
    }

    /// What is beside it says what it is: most of its length counts.
    [[nodiscard]] CurveGuess look_at(const CurveSet& set) const {
        CurveGuess curve{.name = set.name};
        double one_side = 0, both_sides = 0;
        bool closed = false;
        for (const Polyline& piece : set.pieces) {
            curve.longest = std::max(curve.longest, piece.length());
            curve.shortest = std::min(curve.shortest, piece.length());
            closed = closed || piece.closed;
            for_each_segment(piece, [&](const Vec& a, const Vec& b) {
                const Segment segment{a, b};
                for (const double along : {0.125, 0.375, 0.625, 0.875}) {
                    const Vec position = a + along * (b - a), aside = beside * size_ * segment.left();
                    const int sides = (is_fluid(position + aside) ? 1 : 0) + (is_fluid(position - aside) ? 1 : 0);
                    (sides == 2 ? both_sides : one_side) += sides > 0 ? segment.length() : 0;
                }
            });
        }
        if (both_sides > 9 * one_side)
            curve.role = closed ? CurveRole::nothing : CurveRole::flexible;
        else if (one_side > 0)
            curve.role = CurveRole::wall;
        return curve;
    }

    void find_edges() {
        std::vector<NearestCurve> named;
        for (const CurveSet& set : geometry_.curves) named.emplace_back(set, beside * size_);
        for (const Region& region : geometry_.regions)
            for_each_segment(region, [&](const Vec& a, const Vec& b) {
                const Segment segment{a, b};
                if (is_fluid(segment.middle() - beside * size_ * segment.left())) return;
                Edge edge{segment, &region, {}};
                for (std::size_t k = 0; k < named.size(); ++k)
                    if (named[k].nearest(segment.middle())) edge.names.push_back(k);
                for (int side = 0; side < 4; ++side) {
                    const double position = (side % 2 == 0 ? guess_.box.low : guess_.box.high)[side / 2];
                    if (std::max(std::abs(a[side / 2] - position), std::abs(b[side / 2] - position)) <= on_side * size_)
                        edge.side = side;
                }
                edges_.push_back(std::move(edge));
            });
    }

    /// Whether a curve is nothing but (part of) a side of the box.
    [[nodiscard]] bool is_flat(std::size_t curve, int side) const {
        const double position = (side % 2 == 0 ? guess_.box.low : guess_.box.high)[side / 2];
        return std::ranges::all_of(geometry_.curves[curve].pieces, [&](const Polyline& piece) {
            return std::ranges::all_of(
                piece.points, [&](const Vec& p) { return std::abs(p[side / 2] - position) <= on_side * size_; });
        });
    }

    void find_periods() {
        std::array<Intervals, 4> sides;
        std::array<bool, 4> nameless{true, true, true, true}, may_open{true, true, true, true};
        bool any_name = false;
        for (const Edge& edge : edges_) {
            any_name = any_name || !edge.names.empty();
            if (edge.side < 0) continue;
            const auto side = static_cast<std::size_t>(edge.side);
            const int along = 1 - edge.side / 2;
            sides.at(side).emplace_back(std::minmax(edge.segment.a[along], edge.segment.b[along]));
            nameless.at(side) = nameless.at(side) && edge.names.empty();
            for (const std::size_t name : edge.names) may_open.at(side) = may_open.at(side) && is_flat(name, edge.side);
        }
        const double tolerance = on_side * size_;
        for (Intervals& side : sides) side = joined(std::move(side), tolerance);
        const auto goes_on = [&](std::size_t axis, const std::array<bool, 4>& open) {
            return open.at(2 * axis) && open.at(2 * axis + 1) &&
                   alike(sides.at(2 * axis), sides.at(2 * axis + 1), tolerance);
        };
        for (std::size_t axis = 0; axis < 2; ++axis) guess_.periodic.at(axis) = any_name && goes_on(axis, nameless);
        const auto longest = static_cast<std::size_t>(guess_.longest_axis());
        if (!guess_.periodic[0] && !guess_.periodic[1]) guess_.periodic.at(longest) = goes_on(longest, may_open);
        for (const Edge& edge : edges_)
            if (is_end(edge))
                for (const std::size_t name : edge.names) guess_.curves[name].role = CurveRole::end;
    }

    [[nodiscard]] bool is_end(const Edge& edge) const {
        return edge.side >= 0 && guess_.periodic.at(static_cast<std::size_t>(edge.side / 2));
    }

    /// Edges that no curve names: by the sides of the box that they lie on, else all of an area's that are left.
    void find_walls() {
        for (const Region& region : geometry_.regions) {
            std::array<bool, 4> on{}, ends{};
            bool any = false, all_flat = true;
            std::set<std::string> names;
            for (const Edge& edge : edges_) {
                if (edge.of != &region) continue;
                for (const std::size_t name : edge.names) names.insert(guess_.curves[name].name);
                const auto side = static_cast<std::size_t>(std::max(edge.side, 0));
                if (!is_end(edge)) walls_.push_back(edge.segment);
                if (!edge.names.empty()) continue;
                if (is_end(edge)) ends.at(side) = true;
                if (is_end(edge)) continue;
                any = true;
                all_flat = all_flat && edge.side >= 0;
                if (edge.side >= 0) on.at(side) = true;
            }
            if (!any) continue;
            std::vector<std::string> taken(names.begin(), names.end());
            for (std::size_t side = 0; side < 4; ++side) {
                if (!(all_flat ? on : ends).at(side)) continue;
                FaceSelection& flat = (all_flat ? guess_.walls : guess_.caps).emplace_back(selection_of(region, side));
                if (all_flat) flat.except = taken;
                if (!all_flat) taken.push_back(flat.name);
            }
            if (all_flat) continue;
            FaceSelection rest = selection_of(region, 4);
            rest.except = taken;
            if (taken.empty())  // finer particles follow round walls further out
                rest.in_box = Box{guess_.box.low - guess_.box.extent(), guess_.box.high + guess_.box.extent()};
            guess_.walls.push_back(rest);
        }
    }

    /// Of one side of the box, or of all (4).
    [[nodiscard]] FaceSelection selection_of(const Region& region, std::size_t side) const {
        constexpr std::array<const char*, 5> names{"left", "right", "bottom", "top", "wall"};
        std::vector<std::string> taken = geometry_.names();
        for (const auto* list : {&guess_.caps, &guess_.walls})
            for (const FaceSelection& selection : *list) taken.push_back(selection.name);
        const std::string name = geometry_.regions.size() > 1 ? region.name + "_" + names.at(side) : names.at(side);
        FaceSelection selection{.name = name_that_is_free(name, taken), .of = region.name};
        if (side < 4)
            selection.in_plane.at(side / 2) =
                (side % 2 == 0 ? guess_.box.low : guess_.box.high)[static_cast<Eigen::Index>(side / 2)];
        return selection;
    }

    [[nodiscard]] double distance_to_walls(const Vec& position) const {
        Projection best{.distance = std::numeric_limits<double>::infinity()};
        for (const Segment& wall : walls_) keep_nearest(best, position, wall.a, wall.b);
        return best.distance;
    }

    /// From a loose end of a flexible piece to all other flexible pieces.
    [[nodiscard]] double distance_to_others(const Vec& position, const Polyline* own) const {
        Projection best{.distance = std::numeric_limits<double>::infinity()};
        for (std::size_t k = 0; k < guess_.curves.size(); ++k) {
            if (guess_.curves[k].role != CurveRole::flexible) continue;
            for (const Polyline& piece : geometry_.curves[k].pieces)
                if (&piece != own)
                    for_each_segment(piece, [&](const Vec& a, const Vec& b) { keep_nearest(best, position, a, b); });
        }
        return best.distance;
    }

    void inspect_ends(CurveGuess& curve) {
        for (const Polyline& piece : geometry_.curve_set(curve.name)->pieces)
            for (const Vec& end : {piece.points.front(), piece.points.back()}) {
                const double to_wall = distance_to_walls(end);
                if (to_wall <= on_curve * size_)
                    curve.held_ends.push_back(end);
                else
                    guess_.narrowest_tip = std::min({guess_.narrowest_tip, to_wall, distance_to_others(end, &piece)});
            }
        const auto hold = [&](const std::string& name, const auto& near) {
            const auto held = static_cast<std::size_t>(std::ranges::count_if(curve.held_ends, near));
            if (held <= curve.anchored) return;
            curve.anchor = name;
            curve.anchored = held;
        };
        for (const auto& named : geometry_.points)
            hold(named.first, [&](const Vec& end) {
                return std::ranges::any_of(named.second,
                                           [&](const Vec& p) { return (p - end).norm() <= on_side * size_; });
            });
        const auto hold_by_wall = [&](const std::string& name) {
            const NearestCurve nearest(*selected_.curve_set(name), on_curve * size_);
            hold(name, [&](const Vec& end) { return nearest.nearest(end).has_value(); });
        };
        for (const CurveGuess& wall : guess_.curves)
            if (wall.role == CurveRole::wall) hold_by_wall(wall.name);
        for (const FaceSelection& wall : guess_.walls) hold_by_wall(wall.name);
    }

    const Geometry& geometry_;
    Geometry selected_;  ///< with curves for the edges that have no name
    std::vector<InsideTest> fluids_;
    std::vector<Edge> edges_;
    std::vector<Segment> walls_;  ///< edges that are no ends of the period
    double size_ = 0;
    PlaneGuess guess_;
};

}  // namespace

bool PlaneGuess::is_flexible() const { return std::ranges::count(curves, CurveRole::flexible, &CurveGuess::role) > 0; }

bool PlaneGuess::is_a_straight_channel() const {
    return periodic[0] != periodic[1] && !is_flexible() &&
           std::abs(area / (box.extent().x() * box.extent().y()) - 1) < 1e-6;
}

PlaneGuess guess_of_plane(const Geometry& geometry) { return Look(geometry).guess(); }

}  // namespace dmp::cli
