// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// What points of surfaces touch.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "solver/contact/surface_contact.hpp"

namespace dmp::solver {

namespace {

/// Normals of surfaces that touch have a cosine below this.
constexpr double most_facing = -0.3;

}  // namespace

/// The gap of a point before a place of a piece; `normal` out of it, along the gap.
double SurfaceContact::gap_at(const Vec& from, int number, const PiecePlace& place, const Vec& shift,
                              Vec& normal) const {
    const SurfacePiece& other = piece(number).now;
    const Vec off = from - (other.at(place) + shift);
    normal = other.normal(place);
    const bool is_inside = std::ranges::all_of(std::span(place).first(other.corners), [](double p) { return p > 0; });
    if (is_inside) return off.dot(normal);
    // A corner, or an edge: in front of it is where the mean of the normals around it points to.
    const double distance = off.norm(),
                 gap = off.dot(surfaces_.normal_at_border(number, place)) < 0 ? -distance : distance;
    if (distance > 1e-9 * space_.spacing) normal = off / gap;
    return gap;
}

SurfaceContact::Nearest SurfaceContact::nearest_to(int number, std::size_t point) const {
    const auto& own = piece(number);
    const PiecePlace& at_own = surfaces_.points()[point].place;
    const Vec from = own.now.at(at_own), facing_from = own.now.normal(at_own);
    Nearest found;
    double nearest = deepest_ * deepest_;
    for (const PiecePairs::Other& other : near_[index_of(number, point)].others) {
        const auto& met = piece(other.piece);
        const SurfacePiece& shape = met.now;
        // Nothing of the piece is nearer than the box around it.
        const Vec at = from - other.shift;
        if ((met.low - at).cwiseMax(at - met.high).cwiseMax(0).squaredNorm() > (1 + 1e-12) * nearest) continue;
        const PiecePlace place = shape.nearest(at);
        const double square = (at - shape.at(place)).squaredNorm();
        if (!(square <= nearest) || !(shape.normal(place).dot(facing_from) <= most_facing)) continue;
        // Of equally near pieces the first, in whatever order they are looked at.
        if (square == nearest && found.other >= 0 && found.other < other.piece) continue;
        nearest = square;
        found = {other.piece, place, other.shift};
    }
    return found;
}

SurfaceContact::Near SurfaceContact::near_to(int number, std::size_t point) const {
    constexpr double faces = -0.8;
    const PiecePlace& at_own = surfaces_.points()[point].place;
    const Vec from = piece(number).now.at(at_own), facing_from = piece(number).now.normal(at_own);
    Near near;
    std::vector<std::pair<double, PiecePairs::Other>> found;
    double nearest_that_faces = deepest_, nearest = deepest_;
    bool is_behind = false;
    for (const PiecePairs::Other& other : pairs_.others(number)) {
        const auto& met = piece(other.piece);
        const SurfacePiece& shape = met.now;
        const Vec at = from - other.shift;
        if ((met.low - at).cwiseMax(at - met.high).cwiseMax(0).norm() > deepest_ + PiecePairs::skin * space_.spacing)
            continue;
        const PiecePlace place = shape.nearest(at);
        const double distance = (at - shape.at(place)).norm();
        found.emplace_back(distance, other);
        if (shape.normal(place).dot(facing_from) < faces) nearest_that_faces = std::min(nearest_that_faces, distance);
        if (!(distance < deepest_)) continue;
        Vec normal;
        is_behind = is_behind || gap_at(from, other.piece, place, other.shift, normal) < 0;
        nearest = std::min(nearest, distance);
    }
    near.clearance = is_behind ? 0 : nearest;
    // That one may go away by the skin, and others come nearer by it.
    const double far = nearest_that_faces + 2 * PiecePairs::skin * space_.spacing;
    std::erase_if(found, [&](const auto& each) { return each.first > far; });
    std::ranges::stable_sort(found, {}, [](const auto& each) { return each.first; });
    for (const auto& [distance, other] : found) near.others.push_back(other);
    return near;
}

void SurfaceContact::find_pairs() {
    if (!pairs_.update(surfaces_)) return;
    const std::vector<int>& active = pairs_.active();
    const auto count = static_cast<std::ptrdiff_t>(active.size());
    near_.assign(near_.size(), {});
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
    for (std::ptrdiff_t k = 0; k < count; ++k)
        for (std::size_t p = 0; p < surfaces_.points().size(); ++p) {
            const int number = active[static_cast<std::size_t>(k)];
            near_[index_of(number, p)] = near_to(number, p);
        }
}

/// How far a point is behind the nearest piece, whether that faces it or not; 0 where that is a corner or an edge,
/// beyond which it may be in front of another one.
double SurfaceContact::depth_behind(int number, std::size_t point, int& nearest_piece) const {
    const Vec from = piece(number).now.at(surfaces_.points()[point].place);
    double nearest = deepest_, depth = 0;
    for (const PiecePairs::Other& other : near_[index_of(number, point)].others) {
        const SurfacePiece& shape = piece(other.piece).now;
        const PiecePlace place = shape.nearest(from - other.shift);
        const Vec off = from - other.shift - shape.at(place);
        const double distance = off.norm(), along = off.dot(shape.normal(place));
        if (!(distance < nearest)) continue;
        nearest = distance;
        nearest_piece = other.piece;
        depth = along < -0.999 * distance ? distance : 0;
    }
    return depth;
}

SurfaceContact::Deepest SurfaceContact::passed() const {
    Deepest deepest;
    for (const int number : pairs_.active())
        for (std::size_t p = 0; p < surfaces_.points().size(); ++p) {
            const std::size_t index = index_of(number, p);
            if (near_[index].clearance > PiecePairs::skin * space_.spacing) continue;
            int other = -1;
            const double depth = depth_behind(number, p, other);
            // No deeper than the solid is thick.
            if (!(depth > deepest.depth) || depth > piece(other).thickness || is_drawn_inside_[index] ||
                piece(number).is_root)
                continue;
            deepest = {
                depth, t_, piece(number).now.at(surfaces_.points()[p].place), {piece(number).part, piece(other).part}};
        }
    return deepest;
}

/// A point gets no farther behind a surface, nor out of it, than it moves in a step, if it is not more than twice as
/// fast there as now. Where a corner has gone in at which nothing faces it, and then turns, the gap jumps: it counts
/// from where it was.
double SurfaceContact::start_of(const Touch& touch, double gap) const {
    const std::size_t index = index_of(touch.own, touch.number);
    const int solid = piece(touch.other).solid;
    const double start = start_[index].solid == solid ? start_[index].gap : 0;
    const double before = memory_[index].solid == solid ? memory_[index].gap : 0;
    const double jump = gap - start - before;
    const double least = 1e-3 * space_.spacing;
    if (gap >= 0 || std::abs(jump) <= least) return start;
    const double way = 2 * dt_ * (fastest_at(touch.own) + fastest_at(touch.other)) + least;
    return std::abs(jump) <= way ? start : std::min(0.0, gap - before);
}

/// Of its control points [m/s].
double SurfaceContact::fastest_at(int number) const {
    const auto& of = piece(number);
    if (of.is_wall) return velocity_at(number, of.now.middle()).norm();
    double fastest = 0;
    for (std::size_t c = 0; c < of.now.controls(); ++c)
        fastest = std::max(fastest, surfaces_.carried(of.control[c], velocity_).norm());
    return fastest;
}

SurfaceContact::Touch SurfaceContact::touch_of(int number, std::size_t point, double margin, bool drawn) const {
    const auto& own = piece(number);
    const std::size_t index = index_of(number, point);
    Touch touch;
    touch.own = number;
    touch.number = point;
    if (near_[index].clearance > PiecePairs::skin * space_.spacing + margin) return touch;
    touch.from = own.now.at(place_of(touch));
    const auto [nearest, place, shift] = nearest_to(number, point);
    touch.other = nearest;
    touch.place = place;
    if (touch.other < 0) return touch;
    const auto& other = piece(touch.other);
    touch.gap = gap_at(touch.from, touch.other, touch.place, shift, touch.normal);
    touch.at = other.now.at(touch.place) + shift;
    // What a thin body has passed through in one step it is beyond; once it touches, it is followed deeper.
    const bool touched = memory_[index].solid == other.solid;
    const double deepest = touched ? deepest_ : std::min(deepest_, 0.5 * (own.thickness + other.thickness));
    touch.is_apart = touch.gap > 0;
    touch.start = drawn ? 0 : start_of(touch, touch.gap);
    touch.gap -= touch.start;
    if (-touch.gap > deepest) return touch;
    touch.is_one = touch.gap < margin && !surfaces_.is_end(touch.other, touch.place);
    const double here = ContactSurfaces::weight(own, place_of(touch)).value;
    const auto [there, slope] = ContactSurfaces::weight(other, touch.place);
    touch.share = there / (here + there);
    touch.share_slope = slope * here / ((here + there) * (here + there));
    return touch;
}

void SurfaceContact::find_touches(double margin, bool drawn) {
    const std::size_t points = surfaces_.points().size();
    const std::vector<int>& active = pairs_.active();
    for (const int number : examined_)
        if (pairs_.others(number).empty())
            for (std::size_t p = 0; p < points; ++p) {
                memory_[index_of(number, p)] = {};
                start_[index_of(number, p)] = {};
            }
    examined_ = active;
    touches_.assign(active.size() * points, Touch{});
    const auto count = static_cast<std::ptrdiff_t>(active.size());
#pragma omp parallel for num_threads(threads_) schedule(dynamic, 16)
    for (std::ptrdiff_t k = 0; k < count; ++k)
        for (std::size_t p = 0; p < points; ++p) {
            const int number = active[static_cast<std::size_t>(k)];
            const std::size_t index = index_of(number, p);
            const Touch touch = touch_of(number, p, margin, drawn);
            touches_[static_cast<std::size_t>(k) * points + p] = touch;
            const int other = touch.other < 0 ? no_solid : piece(touch.other).solid;
            // It has left another solid once it is in front of it.
            start_[index] = touch.start < 0 && !touch.is_apart ? Start{other, touch.start} : Start{};
            if (memory_[index].solid != (touch.is_one ? other : no_solid)) memory_[index] = {};
        }
    std::erase_if(touches_, [](const Touch& touch) { return !touch.is_one; });
}

}  // namespace dmp::solver
