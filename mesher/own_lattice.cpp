// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/own_lattice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "geometry/nearest_curve.hpp"
#include "geometry/nearest_triangle.hpp"
#include "mesher/whole_cells.hpp"

namespace dmp::mesher {

namespace {

/// A solid's edge so near to its anchor lies on it; coordinates this near to each other are one [spacings].
constexpr double touching = 0.02, same_place = 1e-6;

void widen(Box& box, const Vec& point) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
}
Box nowhere() {
    const Vec far = Vec::Constant(std::numeric_limits<double>::infinity());
    return {far, -far};
}

/// How much of a solid's edge lies in the sides of the box around it.
class FlatSides {
  public:
    FlatSides(const Box& extent, double spacing) : extent_(extent), spacing_(spacing) {}
    /// `size`: of the piece of the edge with these corners [m], in 3-D [m^2].
    void add(std::initializer_list<Vec> corners, double size) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const std::size_t side : {0, 1}) {
                const auto at = static_cast<int>(axis);
                const double place = (side == 0 ? extent_.low : extent_.high)[at];
                if (std::ranges::all_of(corners, [&](const Vec& corner) {
                        return std::abs(corner[at] - place) <= same_place * spacing_;
                    }))
                    size_.at(axis).at(side) += size;
            }
    }
    [[nodiscard]] std::array<std::array<bool, 2>, 3> of_size(double least) const {
        std::array<std::array<bool, 2>, 3> flat{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const std::size_t side : {0, 1}) flat.at(axis).at(side) = size_.at(axis).at(side) >= least;
        return flat;
    }

  private:
    const Box& extent_;
    double spacing_;
    std::array<std::array<double, 2>, 3> size_{};
};

/// The coordinates that all points share.
std::array<std::optional<double>, 3> shared(const Box& of_points, double spacing) {
    std::array<std::optional<double>, 3> same{};
    for (int axis = 0; axis < 3; ++axis)
        if (const double low = of_points.low[axis], high = of_points.high[axis];
            high >= low && high - low <= same_place * spacing)
            same.at(static_cast<std::size_t>(axis)) = (low + high) / 2;
    return same;
}

/// Of a closed polygon; negative where it turns right [m^2].
double turned_area(const std::vector<Vec>& polygon) {
    double twice = 0;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Vec a = polygon[n] - polygon[0], b = polygon[(n + 1) % polygon.size()] - polygon[0];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

/// Of what is clamped, whose corners are counted: the rim belongs to one piece only, what is within it to two.
template <class Corner>
class Rim {
  public:
    void add(const Corner& corner, std::initializer_list<Vec> points) {
        auto& [times, places] = seen_[corner];
        ++times;
        places.assign(points);
    }
    [[nodiscard]] bool empty() const { return seen_.empty(); }
    [[nodiscard]] Box box() const {
        Box box = nowhere();
        for (const auto& [corner, seen] : seen_)
            if (seen.first == 1)
                for (const Vec& point : seen.second) widen(box, point);
        return box;
    }

  private:
    std::map<Corner, std::pair<int, std::vector<Vec>>> seen_;
};

}  // namespace

LatticeMarks marks_of(const Region& region, const CurveSet* anchor, double spacing) {
    LatticeMarks marks;
    marks.extent = nowhere();
    for (const Polyline& loop : region.loops)
        for (const Vec& point : loop.points) widen(marks.extent, point);
    FlatSides flat(marks.extent, spacing);
    for (const Polyline& loop : region.loops)
        for (std::size_t n = 0; n < loop.points.size(); ++n) {
            const Vec &from = loop.points[n], &to = loop.points[(n + 1) % loop.points.size()];
            flat.add({from, to}, (to - from).norm());
        }
    marks.flat = flat.of_size(spacing);
    if (anchor == nullptr) return marks;
    const NearestCurve held_by(*anchor, touching * spacing);
    const auto is_on = [&](const Vec& point) { return held_by.nearest(point).has_value(); };
    Rim<std::pair<std::size_t, std::size_t>> rim;  // of points, by loop
    for (std::size_t k = 0; k < region.loops.size(); ++k) {
        const std::vector<Vec>& points = region.loops[k].points;
        for (std::size_t n = 0; n < points.size(); ++n) {
            const std::size_t next = (n + 1) % points.size();
            const Vec &from = points[n], &to = points[next];
            if (!is_on(from) || !is_on(to) || !is_on((from + to) / 2)) continue;
            rim.add({k, n}, {from});
            rim.add({k, next}, {to});
        }
    }
    Box ends = rim.box();
    if (rim.empty())
        for (const Polyline& piece : anchor->pieces)
            for (const Vec& point : piece.points) widen(ends, point);
    marks.anchor = shared(ends, spacing);
    return marks;
}

Region behind_anchor(const Region& region, const CurveSet& anchor, double spacing) {
    const NearestCurve held_by(anchor, touching * spacing);
    const auto is_on = [&](const Vec& point) { return held_by.nearest(point).has_value(); };
    Region behind{region.name, {}};
    for (const Polyline& loop : region.loops) {
        const std::vector<Vec>& points = loop.points;
        const auto is_held = [&](std::size_t n) {
            const Vec &from = points[n % points.size()], &to = points[(n + 1) % points.size()];
            return is_on(from) && is_on(to) && is_on((from + to) / 2);
        };
        for (std::size_t first = 0; first < points.size(); ++first) {
            if (!is_held(first) || is_held(first + points.size() - 1)) continue;
            Polyline chain{{points[first]}, true};
            for (std::size_t n = first; n < first + points.size() && is_held(n); ++n)
                chain.points.push_back(points[(n + 1) % points.size()]);
            // The area lies on the left of its loops: what the chain and its chord enclose is no part of it where the
            // chain turns right.
            if (!(turned_area(chain.points) < 0)) continue;
            std::ranges::reverse(chain.points);
            behind.loops.push_back(std::move(chain));
        }
    }
    return behind;
}

LatticeMarks marks_of(const TriangleSurface& solid, const TriangleSurface* anchor, double spacing) {
    LatticeMarks marks;
    marks.extent = nowhere();
    for (const Vec& corner : solid.corners) widen(marks.extent, corner);
    FlatSides flat(marks.extent, spacing);
    for (const auto& [i, j, k] : solid.triangles) {
        const auto corner = [&](int n) -> const Vec& { return solid.corners[static_cast<std::size_t>(n)]; };
        flat.add({corner(i), corner(j), corner(k)}, 0.5 * (corner(j) - corner(i)).cross(corner(k) - corner(i)).norm());
    }
    marks.flat = flat.of_size(spacing * spacing);
    if (anchor == nullptr) return marks;
    const NearestTriangle held_by(*anchor, touching * spacing);
    const auto is_on = [&](const Vec& point) { return held_by.nearest(point).has_value(); };
    Rim<std::pair<int, int>> rim;  // of edges
    for (const auto& triangle : solid.triangles) {
        const auto corner = [&](std::size_t k) -> const Vec& {
            return solid.corners[static_cast<std::size_t>(triangle.at(k % 3))];
        };
        if (!is_on(corner(0)) || !is_on(corner(1)) || !is_on(corner(2))) continue;
        if (!is_on((corner(0) + corner(1) + corner(2)) / 3)) continue;
        for (std::size_t k = 0; k < 3; ++k)
            rim.add(std::minmax({triangle.at(k), triangle.at((k + 1) % 3)}), {corner(k), corner(k + 1)});
    }
    Box ends = rim.box();
    if (rim.empty())
        for (const Vec& point : anchor->corners) widen(ends, point);
    marks.anchor = shared(ends, spacing);
    return marks;
}

BoxLattice own_lattice(const ParticleSpace& space, const BoxLattice& of_scene, const LatticeMarks& marks) {
    BoxLattice own = of_scene;
    for (int axis = 0; axis < space.dimension; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const double step = of_scene.step[axis], a_little = same_place * step;
        const double low = marks.extent.low[axis], high = marks.extent.high[axis];
        const bool at_low = low <= space.box.low[axis] + a_little, at_high = high >= space.box.high[axis] - a_little;
        const bool is_held = (at_low && (space.periodic.at(at) || space.mirrored.at(at)[0])) ||
                             (at_high && (space.periodic.at(at) || space.mirrored.at(at)[1]));
        if (is_held || !(high > low)) continue;
        const auto& flat = marks.flat.at(at);
        double mark = flat[0] ? low : high;
        if (const auto& anchor = marks.anchor.at(at); anchor && *anchor >= low - a_little && *anchor <= high + a_little)
            mark = *anchor;
        else if (!flat[0] && !flat[1])
            continue;
        const double length = std::max(flat[0] ? mark - low : 0.0, flat[1] ? high - mark : 0.0);
        const double cells = whole_cells(length / step), fitted = length / cells;
        const bool is_fitted = std::abs(fitted / step - 1) <= most_stretched;
        const double off = (mark - of_scene.origin[axis]) / step;
        const bool is_scenes = std::abs(off - std::round(off)) <= same_place &&
                               (!is_fitted || std::abs(length - cells * step) <= a_little);
        if (is_scenes) continue;
        own.step[axis] = is_fitted ? fitted : step;
        own.origin[axis] = mark;
        own.period.at(at) = 0;
        own.first.at(at) = BoxLattice::lowest;
        own.last.at(at) = BoxLattice::highest;
    }
    return own;
}

std::string lattice_text(const BoxLattice& of_scene, const BoxLattice& own) {
    std::ostringstream text;
    text.precision(3);
    for (int axis = 0; axis < own.dimension; ++axis) {
        if (own.origin[axis] == of_scene.origin[axis] && own.step[axis] == of_scene.step[axis]) continue;
        const double off = (own.origin[axis] - of_scene.origin[axis]) / of_scene.step[axis];
        text << (text.tellp() > 0 ? ", along " : "along ") << "xyz"[axis] << " shifted by " << off - std::floor(off)
             << " spacings";
        if (const double stretch = own.step[axis] / of_scene.step[axis] - 1; std::abs(stretch) > 1e-9)
            text << " and stretched by " << 100 * stretch << " %";
    }
    if (text.tellp() == 0) return {};
    return "with nodes on its anchor or its sides: " + text.str();
}

}  // namespace dmp::mesher
