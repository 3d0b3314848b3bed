// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/features.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "geometry/segments.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

namespace {

/// Cosine of the angle from which on a surface has a corner or an edge.
const double sharp = std::cos(40 * std::numbers::pi / 180);
/// Cosine of the angle from which on two faces lie back to back: a sheet, with no inside to its edge.
const double folded = std::cos(150 * std::numbers::pi / 180);
/// How far from a corner one looks where the fluid is [spacings].
constexpr double beside = 0.05;
/// How far the deep point of a place is from the corner, in units of the place's own distance.
constexpr double deeper = 4;
/// Shorter lines are no edges of a body at this spacing [spacings].
constexpr double shortest_line = 4;

/// Numbers for points with equal coordinates.
class PointNumbers {
  public:
    int of(const Vec& point) {
        const auto [at, is_new] =
            numbers_.try_emplace({point.x(), point.y(), point.z()}, static_cast<int>(points_.size()));
        if (is_new) points_.push_back(point);
        return at->second;
    }
    [[nodiscard]] const std::vector<Vec>& points() const { return points_; }

  private:
    std::map<std::array<double, 3>, int> numbers_;
    std::vector<Vec> points_;
};

/// Two faces that meet: the vector from where they do to where each is at distance 1 in front, turned towards the
/// fluid, and their normals there. Nothing where they hardly turn, or where not exactly one side is fluid.
struct Wedge {
    Vec offset, first, second;
};

std::optional<Wedge> wedge_at(const Vec& point, const Vec& first, const Vec& second, const IsFluid& is_fluid,
                              double spacing) {
    const double cosine = first.dot(second);
    if (!(cosine < sharp) || cosine < folded) return std::nullopt;
    const Vec offset = (first + second) / (1 + cosine);
    const bool before = is_fluid(point + beside * spacing * offset);
    if (before == is_fluid(point - beside * spacing * offset)) return std::nullopt;
    const double sign = before ? 1 : -1;
    return Wedge{sign * offset, sign * first, sign * second};
}

void add_both(std::vector<FeaturePosition>& positions, const Vec& point, const Vec& offset, double spacing) {
    const Vec half = spacing / 2 * offset;
    positions.push_back({point + half, point + deeper * half, true});
    positions.push_back({point - half, point - deeper * half, false});
}

/// Lines of edges of a surface.
class Edges {
  public:
    Edges(const std::vector<const TriangleSurface*>& surfaces, const IsFluid& is_fluid, double spacing)
        : spacing_(spacing) {
        find(surfaces, is_fluid);
        by_point_.resize(numbers_.points().size());
        for (std::size_t e = 0; e < edges_.size(); ++e)
            for (const int point : edges_[e].ends) by_point_[static_cast<std::size_t>(point)].push_back(e);
        used_.assign(edges_.size(), false);
    }

    std::vector<FeaturePosition> positions() {
        std::vector<std::vector<int>> lines;
        for (std::size_t point = 0; point < by_point_.size(); ++point)
            if (is_end(static_cast<int>(point)))
                for (const std::size_t edge : by_point_[point]) follow(static_cast<int>(point), edge, lines);
        for (std::size_t edge = 0; edge < edges_.size(); ++edge)  // what is left goes around
            follow(edges_[edge].ends[0], edge, lines);
        std::vector<FeaturePosition> positions;
        std::set<int> ends;
        for (const auto& line : lines)
            for (const int end : {line.front(), line.back()})
                if (edges_at(end).size() > 1 && is_end(end) && ends.insert(end).second)
                    add_both(positions, at(end), offset_at(end), spacing_);
        for (const auto& line : lines) add_line(line, positions);
        return positions;
    }

  private:
    struct Edge {
        std::array<int, 2> ends;
        Wedge wedge;
    };

    void find(const std::vector<const TriangleSurface*>& surfaces, const IsFluid& is_fluid) {
        struct Side {
            int low, high;
            bool upward;  ///< the triangle goes from low to high
            Vec normal;
        };
        std::vector<Side> sides;
        for (const TriangleSurface* surface : surfaces) {
            std::vector<int> numbers;
            numbers.reserve(surface->corners.size());
            for (const Vec& corner : surface->corners) numbers.push_back(numbers_.of(corner));
            for (const auto& triangle : surface->triangles) {
                std::array<int, 3> number{};
                for (std::size_t k = 0; k < 3; ++k) number.at(k) = numbers[static_cast<std::size_t>(triangle.at(k))];
                const Vec across = (at(number[1]) - at(number[0])).cross(at(number[2]) - at(number[0]));
                if (!(across.norm() > 0)) continue;
                for (std::size_t k = 0; k < 3; ++k) {
                    const int from = number.at(k), to = number.at((k + 1) % 3);
                    sides.push_back({std::min(from, to), std::max(from, to), from < to, across.normalized()});
                }
            }
        }
        const auto ends = [](const Side& side) { return std::array{side.low, side.high}; };
        std::ranges::stable_sort(sides, {}, ends);
        for (std::size_t k = 0, next = 0; k < sides.size(); k = next) {
            for (next = k + 1; next < sides.size() && ends(sides[next]) == ends(sides[k]);) ++next;
            if (next != k + 2) continue;
            const Vec second = sides[k].upward != sides[k + 1].upward ? sides[k + 1].normal : Vec(-sides[k + 1].normal);
            const Vec middle = 0.5 * (at(sides[k].low) + at(sides[k].high));
            if (const auto wedge = wedge_at(middle, sides[k].normal, second, is_fluid, spacing_))
                edges_.push_back({ends(sides[k]), *wedge});
        }
    }

    [[nodiscard]] const Vec& at(int point) const { return numbers_.points()[static_cast<std::size_t>(point)]; }
    [[nodiscard]] const std::vector<std::size_t>& edges_at(int point) const {
        return by_point_[static_cast<std::size_t>(point)];
    }
    [[nodiscard]] int other_end(std::size_t edge, int point) const {
        const auto& ends = edges_[edge].ends;
        return ends[0] == point ? ends[1] : ends[0];
    }

    [[nodiscard]] bool is_end(int point) const {
        const auto& edges = edges_at(point);
        if (edges.empty()) return false;
        if (edges.size() != 2) return true;
        const Vec in = at(point) - at(other_end(edges[0], point)), out = at(other_end(edges[1], point)) - at(point);
        return in.normalized().dot(out.normalized()) < sharp;
    }

    /// To where all faces at the point are at distance 1 in front, as nearly as can be.
    [[nodiscard]] Vec offset_at(int point) const {
        const auto& edges = edges_at(point);
        Eigen::MatrixXd normals(2 * static_cast<Eigen::Index>(edges.size()), 3);
        Eigen::Index row = 0;
        for (const std::size_t edge : edges) {
            normals.row(row++) = edges_[edge].wedge.first.transpose();
            normals.row(row++) = edges_[edge].wedge.second.transpose();
        }
        // Where the faces say nothing about a direction, the edge's own, the point stays.
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
        solver.setThreshold(0.1);
        return solver.compute(normals).solve(Eigen::VectorXd::Ones(row));
    }

    /// The line that begins with an edge at a point, if it is not yet used and long enough.
    void follow(int start, std::size_t edge, std::vector<std::vector<int>>& lines) {
        if (used_[edge]) return;
        std::vector<int> points{start};
        double length = 0;
        for (int point = start;;) {
            used_[edge] = true;
            const int next = other_end(edge, point);
            length += (at(next) - at(point)).norm();
            point = next;
            points.push_back(point);
            if (is_end(point) || point == start) break;
            edge = edges_at(point)[edges_at(point)[0] == edge ? 1 : 0];
        }
        if (length > shortest_line * spacing_) lines.push_back(points);
    }

    /// The places on a line, both ends' own left out.
    void add_line(const std::vector<int>& points, std::vector<FeaturePosition>& positions) const {
        const bool closed = points.back() == points.front() && !is_end(points.front());
        for (const double side : {0.5, -0.5}) {
            Polyline line, deep;
            for (const int point : points) {
                const Vec offset = side * spacing_ * offset_at(point);
                line.points.emplace_back(at(point) + offset);
                deep.points.emplace_back(at(point) + deeper * offset);
            }
            // Ends with a place of their own are left out; at open ones the line begins with half a step.
            const double first = closed || edges_at(points.front()).size() > 1 ? 0 : 0.5;
            const double last = closed || edges_at(points.back()).size() > 1 ? 0 : 0.5;
            const double length = line.length(), deep_length = deep.length();
            const long steps = std::lround(length / spacing_ - first - last);
            if (steps < 1 || !(deep_length > 0)) continue;
            const double step = 1 / (static_cast<double>(steps) + first + last);
            const long skipped_first = !closed && first == 0 ? 1 : 0, skipped_last = last == 0 ? 1 : 0;
            for (long k = skipped_first; k <= steps - skipped_last; ++k) {
                const double part = std::min(1.0, (static_cast<double>(k) + first) * step);
                positions.push_back({line.at(part * length).first, deep.at(part * deep_length).first, side > 0});
            }
        }
    }

    double spacing_;
    PointNumbers numbers_;
    std::vector<Edge> edges_;
    std::vector<std::vector<std::size_t>> by_point_;
    std::vector<bool> used_;
};

}  // namespace

std::vector<FeaturePosition> corner_positions(const std::vector<const CurveSet*>& curves, const IsFluid& is_fluid,
                                              double spacing) {
    PointNumbers numbers;
    std::vector<std::vector<int>> joined;  // by point
    for (const CurveSet* set : curves)
        for (const Polyline& piece : set->pieces)
            for_each_segment(piece, [&](const Vec& a, const Vec& b) {
                const int from = numbers.of(a), to = numbers.of(b);
                joined.resize(numbers.points().size());
                if (from == to) return;
                joined[static_cast<std::size_t>(from)].push_back(to);
                joined[static_cast<std::size_t>(to)].push_back(from);
            });
    std::vector<FeaturePosition> positions;
    for (std::size_t point = 0; point < joined.size(); ++point) {
        if (joined[point].size() != 2) continue;
        const Vec& here = numbers.points()[point];
        const auto normal = [](const Vec& along) { return Vec(-along.y(), along.x(), 0).normalized(); };
        const auto neighbour = [&](std::size_t k) {
            return numbers.points()[static_cast<std::size_t>(joined[point][k])];
        };
        if (const auto wedge =
                wedge_at(here, normal(here - neighbour(0)), normal(neighbour(1) - here), is_fluid, spacing))
            add_both(positions, here, wedge->offset, spacing);
    }
    return positions;
}

std::vector<FeaturePosition> edge_positions(const std::vector<const TriangleSurface*>& surfaces,
                                            const IsFluid& is_fluid, double spacing) {
    return Edges(surfaces, is_fluid, spacing).positions();
}

}  // namespace dmp::mesher
