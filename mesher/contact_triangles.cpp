// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/contact_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "geometry/divide_long_edges.hpp"
#include "geometry/even_triangles.hpp"
#include "geometry/nearest_triangle.hpp"
#include "geometry/orient_surface.hpp"
#include "geometry/points_inside.hpp"
#include "geometry/surface_pieces.hpp"
#include "geometry/thickened_sheet.hpp"
#include "geometry/triangle_tree.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/contact_surfaces.hpp"
#include "mesher/open_sides.hpp"

namespace dmp::mesher {

namespace {

/// Edges are to be this long, and are no longer than that [spacings].
constexpr double edge_wanted = 0.75, edge_allowed = 1;
/// How far in front of a wall liquid is looked for [spacings].
constexpr double off_the_wall = 0.05;
/// A triangle with less area touches nothing [spacings^2].
constexpr double least_area = 1e-9;

std::array<Vec, 3> corners_of(const TriangleSurface& surface, std::size_t triangle) {
    const auto& [a, b, c] = surface.triangles[triangle];
    const auto at = [&](int corner) { return surface.corners[static_cast<std::size_t>(corner)]; };
    return {at(a), at(b), at(c)};
}

/// Along the outward normal, twice the area [m^2].
Vec facing_of(const TriangleSurface& surface, std::size_t triangle) {
    const auto [a, b, c] = corners_of(surface, triangle);
    return (b - a).cross(c - a);
}

Vec middle_of(const TriangleSurface& surface, std::size_t triangle) {
    const auto [a, b, c] = corners_of(surface, triangle);
    return (a + b + c) / 3;
}

TriangleSurface in_pieces_of_contact(const TriangleSurface& drawn, double spacing) {
    TriangleSurface surface = even_triangles(drawn, edge_wanted * spacing);
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        if (facing_of(surface, t).norm() > 2 * least_area * spacing * spacing)
            triangles.push_back(surface.triangles[t]);
    surface.triangles = std::move(triangles);
    return surface;
}

/// By triangle of a surface that faces outward: how thick the solid behind it is [m].
std::vector<double> thickness_behind(const TriangleSurface& surface, double spacing) {
    const TriangleTree tree(surface);
    std::vector<double> thickness(surface.triangles.size(), farthest_behind * spacing);
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t t = 0; t < thickness.size(); ++t) {
        const Vec inward = -facing_of(surface, t).normalized();
        const auto hit = tree.first_hit(middle_of(surface, t), inward, [&](int other) {
            const auto at = static_cast<std::size_t>(other);
            return at != t && facing_of(surface, at).dot(inward) > 0;
        });
        if (hit) thickness[t] = std::min(thickness[t], hit->distance);
    }
    return thickness;
}

class TriangleWriter {
  public:
    TriangleWriter(int part, ParticleSet& set) : part_(part), set_(set) {}

    /// The triangles of a surface that `is_there(number)`, with the thickness behind it by number.
    template <class IsThere, class Thickness>
    void add(const TriangleSurface& surface, const IsThere& is_there, const Thickness& thickness) {
        std::vector<int> number(surface.corners.size(), -1);
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            if (!is_there(t)) continue;
            std::array<int, 3> points{};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto corner = static_cast<std::size_t>(surface.triangles[t].at(k));
                if (number[corner] < 0) {
                    number[corner] = static_cast<int>(set_.contact_points.size());
                    set_.contact_points.push_back(surface.corners[corner]);
                }
                points.at(k) = number[corner];
            }
            set_.contact_pieces.push_back({part_, points[0], points[1], points[2], thickness(t)});
        }
    }

  private:
    int part_;
    ParticleSet& set_;
};

constexpr auto everywhere = [](std::size_t) { return true; };

void draw_volume(const TriangleSurface& drawn, const ParticleSet& set, TriangleWriter writer) {
    const TriangleSurface surface = in_pieces_of_contact(without_open_sides(drawn, set), set.spacing);
    const std::vector<double> thickness = thickness_behind(surface, set.spacing);
    writer.add(surface, everywhere, [&](std::size_t t) { return thickness[t]; });
}

void draw_sheet(const TriangleSurface& middle, double thickness, const ParticleSet& set, TriangleWriter writer) {
    const TriangleSurface even = in_pieces_of_contact(middle, set.spacing);
    const SurfacePieces pieces(even);
    for (const SurfacePiece& piece : pieces.all()) {
        const TriangleSurface sides =
            thickened_sheet(part_of(even, piece.triangles), thickness, [&](const Vec& a, const Vec& b) {
                return on_open_side(std::array{a, b}, set);
            });
        // The rim is as wide as the sheet is thick.
        writer.add(divide_long_edges(sides, edge_allowed * set.spacing), everywhere,
                   [&](std::size_t) { return thickness; });
    }
}

/// Where liquid or an elastic body may be, which a wall has to keep.
class OpenSpace {
  public:
    OpenSpace(const Geometry& geometry, const Scene& scene) : is_dry_(scene.parts_of(PartKind::fluid).empty()) {
        const auto add = [&](PartKind kind, std::vector<const TriangleSurface*>& to) {
            for (const Part* part : scene.parts_of(kind))
                if (const Solid* solid = geometry.solid(part->name)) to.push_back(&solid->surface);
        };
        add(PartKind::fluid, open_);
        add(PartKind::elastic, open_);
        add(PartKind::rigid, taken_);
    }

    /// By point.
    [[nodiscard]] std::vector<bool> holds(const std::vector<Vec>& points) const {
        if (is_dry_) return std::vector<bool>(points.size(), true);
        std::vector<bool> held(points.size(), false);
        for (const TriangleSurface* solid : open_) set_where_inside(*solid, points, true, held);
        for (const TriangleSurface* solid : taken_) set_where_inside(*solid, points, false, held);
        return held;
    }

  private:
    static void set_where_inside(const TriangleSurface& solid, const std::vector<Vec>& points, bool value,
                                 std::vector<bool>& of) {
        const std::vector<bool> inside = solid.has_holes ? inside_by_vote(solid, points) : points_inside(solid, points);
        for (std::size_t k = 0; k < points.size(); ++k)
            if (inside[k]) of[k] = value;
    }
    static std::vector<bool> inside_by_vote(const TriangleSurface& solid, const std::vector<Vec>& points) {
        const WindingNumber winding(solid);
        std::vector<bool> inside(points.size());
        for (std::size_t k = 0; k < points.size(); ++k) inside[k] = winding.inside(points[k]);
        return inside;
    }

    bool is_dry_;
    std::vector<const TriangleSurface*> open_, taken_;
};

/// By triangle: a point so far in front of its middle, from the surface as it was drawn: triangles do not follow a bend
/// exactly.
std::vector<Vec> in_front_of(const TriangleSurface& surface, const NearestTriangle& drawn_places,
                             const TriangleSurface& drawn, double distance) {
    std::vector<Vec> points(surface.triangles.size());
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t t = 0; t < points.size(); ++t) {
        Vec place = middle_of(surface, t), facing = facing_of(surface, t).normalized();
        if (const auto nearest = drawn_places.nearest(place)) {
            const Vec there = facing_of(drawn, static_cast<std::size_t>(nearest->triangle)).normalized();
            place = nearest->point;
            if (const double alike = there.dot(facing); alike != 0) facing = alike > 0 ? there : Vec(-there);
        }
        points[t] = place + distance * facing;
    }
    return points;
}

void draw_solid_wall(const TriangleSurface& solid, const OpenSpace& open, const ParticleSet& set,
                     TriangleWriter writer) {
    const TriangleSurface drawn = without_open_sides(solid, set);
    const TriangleSurface surface = in_pieces_of_contact(drawn, set.spacing);
    const NearestTriangle places(drawn, set.spacing);
    const std::vector<bool> is_seen = open.holds(in_front_of(surface, places, drawn, off_the_wall * set.spacing));
    const std::vector<double> thickness = thickness_behind(surface, set.spacing);
    writer.add(
        surface, [&](std::size_t t) { return is_seen[t]; }, [&](std::size_t t) { return thickness[t]; });
}

void draw_thin_wall(const TriangleSurface& wall, const OpenSpace& open, const ParticleSet& set, TriangleWriter writer) {
    TriangleSurface drawn = wall;
    orient_outward(drawn);
    const TriangleSurface one = in_pieces_of_contact(drawn, set.spacing);
    const NearestTriangle places(drawn, set.spacing);
    TriangleSurface other = one;
    for (auto& triangle : other.triangles) std::swap(triangle[1], triangle[2]);
    const std::vector<bool> before = open.holds(in_front_of(one, places, drawn, off_the_wall * set.spacing));
    const std::vector<bool> behind = open.holds(in_front_of(other, places, drawn, off_the_wall * set.spacing));
    // One with solid behind it has that only where the other side is not open.
    TriangleSurface with_solid = one;
    std::vector<int> number(one.triangles.size(), -1);
    with_solid.triangles.clear();
    for (std::size_t t = 0; t < number.size(); ++t) {
        if (before[t] == behind[t]) continue;
        number[t] = static_cast<int>(with_solid.triangles.size());
        with_solid.triangles.push_back((before[t] ? one : other).triangles[t]);
    }
    const std::vector<double> deep = thickness_behind(with_solid, set.spacing);
    const auto thickness = [&](std::size_t t) { return number[t] < 0 ? 0 : deep[static_cast<std::size_t>(number[t])]; };
    // With open space on both sides, or none, as above a liquid, it is as thin as it is drawn.
    writer.add(
        one, [&](std::size_t t) { return before[t] || !behind[t]; }, thickness);
    writer.add(
        other, [&](std::size_t t) { return behind[t] || !before[t]; }, thickness);
}

}  // namespace

void draw_contact_triangles(const Geometry& geometry, const Scene& scene, const std::vector<Sheet>& sheets,
                            ParticleSet& set) {
    const auto writer_of = [&](const Part& part) { return TriangleWriter(set.part_named(part.name), set); };
    for (const Part* part : scene.parts_of(PartKind::elastic)) {
        const auto sheet = std::ranges::find(sheets, part, &Sheet::part);
        if (sheet != sheets.end())
            draw_sheet(sheet->surface, thickness_between_sides(*sheet, scene), set, writer_of(*part));
        else if (const Solid* solid = geometry.solid(part->name))
            draw_volume(solid->surface, set, writer_of(*part));
    }
    const OpenSpace open(geometry, scene);
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        if (const Solid* solid = geometry.solid(part->name))
            draw_solid_wall(solid->surface, open, set, writer_of(*part));
        else
            draw_thin_wall(geometry.surface_set(part->name)->surface, open, set, writer_of(*part));
    }
}

}  // namespace dmp::mesher
