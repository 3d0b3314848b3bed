// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/contact_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/inside_test.hpp"
#include "mesher/contact_triangles.hpp"
#include "mesher/open_sides.hpp"

namespace dmp::mesher {

namespace {

/// Pieces are at most this long, and no shorter than half of it where the curve goes on smoothly [spacings].
constexpr double longest_piece = 1;
/// Beyond it a point is a corner [rad].
constexpr double corner_angle = 30 * std::numbers::pi / 180;

Vec left_of(const Vec& along) { return {-along[1], along[0], 0}; }

double turn_at(const Vec& before, const Vec& point, const Vec& after) {
    const Vec in = point - before, out = after - point;
    return std::abs(std::atan2(in[0] * out[1] - in[1] * out[0], in.dot(out)));
}

/// The line in pieces of the right length.
Polyline in_pieces(const Polyline& line, double spacing) {
    std::vector<Vec> kept;
    bool last_is_corner = true;
    const double shortest = 0.5 * longest_piece * spacing;
    const std::size_t count = line.points.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Vec& point = line.points[k];
        const bool is_end = !line.closed && (k == 0 || k + 1 == count);
        const bool is_corner =
            is_end || turn_at(line.points[(k + count - 1) % count], point, line.points[(k + 1) % count]) > corner_angle;
        const double least = is_corner ? 1e-9 : 0.5 * longest_piece;
        // A smooth point so near before a corner makes way for it.
        if (is_corner && !last_is_corner && kept.size() > 1 && (point - kept.back()).norm() < shortest) kept.pop_back();
        if (kept.empty() || (point - kept.back()).norm() >= least * spacing) {
            kept.push_back(point);
            last_is_corner = is_corner;
        } else if (is_end) {
            kept.back() = point;
        }
    }
    if (line.closed && kept.size() > 3 && !last_is_corner && (kept.back() - kept.front()).norm() < shortest)
        kept.pop_back();  // a curve through points at uneven distances would turn back
    Polyline pieces{{}, line.closed};
    const std::size_t lines = line.closed ? kept.size() : kept.size() - 1;
    for (std::size_t k = 0; k < lines; ++k) {
        const Vec &from = kept[k], to = kept[(k + 1) % kept.size()];
        const int parts = std::max(1, static_cast<int>(std::ceil((to - from).norm() / spacing - 1e-9)));
        for (int j = 0; j < parts; ++j) pieces.points.emplace_back(from + (to - from) * j / parts);
    }
    if (!line.closed) pieces.points.push_back(kept.back());
    return pieces;
}

/// To the left of each point by this much, where the lines beside it meet.
std::vector<Vec> beside(const Polyline& line, double distance) {
    constexpr double longest_mitre = 2;
    std::vector<Vec> points;
    const std::size_t count = line.points.size();
    for (std::size_t k = 0; k < count; ++k) {
        const bool is_first = !line.closed && k == 0, is_last = !line.closed && k + 1 == count;
        const Vec in = (line.points[k] - line.points[(k + count - 1) % count]).normalized();
        const Vec out = (line.points[(k + 1) % count] - line.points[k]).normalized();
        const Vec normal = left_of(is_first ? out : in), other = left_of(is_last ? in : out);
        const Vec mean = (normal + other).normalized();
        const double mitre = std::min(longest_mitre, 1 / std::max(1e-9, mean.dot(normal)));
        points.emplace_back(line.points[k] + mitre * distance * mean);
    }
    return points;
}

class LineWriter {
  public:
    explicit LineWriter(ParticleSet& set) : set_(set) {}

    /// With the solid on the left of the line.
    template <class IsThere>
    void add(int part, const Polyline& line, double thickness, const IsThere& is_there) {
        const int first = static_cast<int>(set_.contact_points.size());
        const int count = static_cast<int>(line.points.size());
        set_.contact_points.insert(set_.contact_points.end(), line.points.begin(), line.points.end());
        for (int k = 0; k < (line.closed ? count : count - 1); ++k) {
            const int next = (k + 1) % count;
            const auto at = [&](int point) -> const Vec& { return line.points[static_cast<std::size_t>(point)]; };
            if (is_there(at(k), at(next)))
                set_.contact_pieces.push_back({part, first + k, first + next, ContactPiece::none, thickness});
        }
    }
    void add(int part, const Polyline& line, double thickness) {
        add(part, line, thickness, [](const Vec&, const Vec&) { return true; });
    }

    /// How thick the solid is behind each of its pieces from number `first` on: where a line against the outward normal
    /// leaves it.
    void find_thickness(std::size_t first) {
        std::vector<ContactPiece>& pieces = set_.contact_pieces;
        const double far = farthest_behind * set_.spacing;
        for (std::size_t k = first; k < pieces.size(); ++k) {
            const Vec along = end(pieces[k]) - start(pieces[k]);
            const Vec from = start(pieces[k]) + 0.5 * along, inward = left_of(along.normalized());
            double nearest = far;
            for (std::size_t j = first; j < pieces.size(); ++j) {
                const Vec a = start(pieces[j]) - from, b = end(pieces[j]) - from;
                if (j == k || std::min(a.norm(), b.norm()) > 2 * far) continue;
                const double side_of_a = cross(inward, a), side_of_b = cross(inward, b);
                if ((side_of_a > 0) == (side_of_b > 0)) continue;
                const Vec meeting = a + side_of_a / (side_of_a - side_of_b) * (b - a);
                const double depth = meeting.dot(inward);
                if (depth > 0) nearest = std::min(nearest, depth);
            }
            pieces[k].thickness = nearest;
        }
    }
    [[nodiscard]] std::size_t pieces() const { return set_.contact_pieces.size(); }

  private:
    static double cross(const Vec& a, const Vec& b) { return a[0] * b[1] - a[1] * b[0]; }
    [[nodiscard]] const Vec& start(const ContactPiece& piece) const {
        return set_.contact_points[static_cast<std::size_t>(piece.a)];
    }
    [[nodiscard]] const Vec& end(const ContactPiece& piece) const {
        return set_.contact_points[static_cast<std::size_t>(piece.b)];
    }

    ParticleSet& set_;
};

void draw_area(const Region& region, int part, const ParticleSet& set, LineWriter& writer) {
    const InsideTest inside(region);
    const std::size_t first = writer.pieces();
    for (const Polyline& loop : region.loops) {
        Polyline line{loop.points, true};
        const Vec along = line.points[1] - line.points[0];
        const Vec left = line.points[0] + 0.5 * along + 1e-3 * set.spacing * left_of(along.normalized());
        if (inside.side_of(left) != Side::inside) std::ranges::reverse(line.points);
        writer.add(part, in_pieces(line, set.spacing), 0, [&](const Vec& a, const Vec& b) {
            return !on_open_side(std::array{a, b}, set);
        });
    }
    writer.find_thickness(first);
}

void draw_strip(const Sheet& strip, double thickness, int part, double spacing, LineWriter& writer) {
    for (const Polyline& piece : strip.curves.pieces) {
        const Polyline middle = in_pieces(piece, spacing);
        Polyline right{beside(middle, -thickness / 2), middle.closed},
            left{beside(middle, thickness / 2), middle.closed};
        std::ranges::reverse(left.points);
        if (middle.closed) {
            writer.add(part, right, thickness);
            writer.add(part, left, thickness);
        } else {
            right.points.insert(right.points.end(), left.points.begin(), left.points.end());
            writer.add(part, in_pieces({right.points, true}, spacing), thickness);
        }
    }
}

/// Where liquid or an elastic body may be, which a wall has to keep.
class FreeSpace {
  public:
    FreeSpace(const Geometry& geometry, const Scene& scene) : is_dry_(scene.parts_of(PartKind::fluid).empty()) {
        for (const PartKind kind : {PartKind::fluid, PartKind::elastic})
            for (const Part* part : scene.parts_of(kind))
                if (const Region* region = geometry.region(part->name)) regions_.emplace_back(*region);
    }
    [[nodiscard]] bool holds(const Vec& point) const {
        return is_dry_ || std::ranges::any_of(
                              regions_, [&](const InsideTest& test) { return test.side_of(point) != Side::outside; });
    }

  private:
    bool is_dry_;
    std::vector<InsideTest> regions_;
};

void draw_wall(const CurveSet& curve, int part, const FreeSpace& free, const ParticleSet& set, LineWriter& writer) {
    const double off = 0.05 * set.spacing;
    const auto is_free = [&](const Vec& a, const Vec& b, double side) {
        return free.holds(0.5 * (a + b) + side * off * left_of((b - a).normalized()));
    };
    std::vector<Polyline> lines;
    for (const Polyline& piece : curve.pieces) {
        lines.push_back(in_pieces(piece, set.spacing));
        lines.push_back(lines.back());
        std::ranges::reverse(lines.back().points);
    }
    const std::size_t first = writer.pieces();
    for (const Polyline& line : lines)
        writer.add(part, line, 0, [&](const Vec& a, const Vec& b) { return is_free(a, b, -1) && !is_free(a, b, 1); });
    writer.find_thickness(first);
    // With free space on both sides, or none, as above a liquid, it is as thin as its line.
    for (const Polyline& line : lines)
        writer.add(part, line, 0, [&](const Vec& a, const Vec& b) { return is_free(a, b, -1) == is_free(a, b, 1); });
}

}  // namespace

void draw_contact_surfaces(const Geometry& geometry, const Scene& scene, const std::vector<Sheet>& strips,
                           ParticleSet& set) {
    if (!scene.has_surface_contact()) return;
    if (set.dimension == 3) return draw_contact_triangles(geometry, scene, strips, set);
    LineWriter writer(set);
    for (const Part* part : scene.parts_of(PartKind::elastic)) {
        const int number = set.part_named(part->name);
        const auto strip = std::ranges::find(strips, part, &Sheet::part);
        if (strip != strips.end()) {
            draw_strip(*strip, thickness_between_sides(*strip, scene), number, set.spacing, writer);
        } else if (const Region* region = geometry.region(part->name)) {
            draw_area(*region, number, set, writer);
        }
    }
    const FreeSpace free(geometry, scene);
    for (const Part* part : scene.parts_of(PartKind::rigid))
        draw_wall(*geometry.curve_set(part->name), set.part_named(part->name), free, set, writer);
}

}  // namespace dmp::mesher
