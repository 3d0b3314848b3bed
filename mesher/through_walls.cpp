// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/through_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "base/length_text.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/nearest_curve.hpp"
#include "geometry/nearest_triangle.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/space_builder.hpp"

namespace dmp::mesher {

namespace {

constexpr double beyond = 0.25, touching = 0.05;  // [spacings]

/// All fluids of a scene together.
class Fluids {
  public:
    Fluids(const Geometry& geometry, const Scene& scene)
        : dimension_(geometry.dimension),
          box_(dimension_ == 3 ? fluid_box_in_space(geometry, scene) : fluid_box(geometry, scene)) {
        for (std::size_t axis = 0; axis < 3; ++axis) periodic_.at(axis) = *scene.flow.periodic.at(axis);
        const double spacing = scene.particles.spacing;
        CurveSet edges;
        for (const Part* part : scene.parts_of(PartKind::fluid)) {
            if (const Solid* solid = geometry.solid(part->name)) {
                solids_.emplace_back(solid->surface);
                surfaces_.emplace_back(solid->surface, beyond * spacing);
            } else if (const Region* region = geometry.region(part->name)) {
                areas_.emplace_back(*region);
                for (Polyline loop : region->loops) {
                    loop.closed = true;
                    edges.pieces.push_back(std::move(loop));
                }
            }
        }
        if (!edges.pieces.empty()) edges_.emplace(edges, beyond * spacing);
    }

    [[nodiscard]] bool hold(const Vec& point) const {
        return std::ranges::any_of(areas_, [&](const auto& area) { return area.side_of(point) == Side::inside; }) ||
               std::ranges::any_of(solids_, [&](const auto& solid) { return solid.inside(point); });
    }

    /// More than a quarter of a spacing outside of all of them, and not across a periodic side.
    [[nodiscard]] bool are_left_behind(const Vec& point) const {
        if (hold(point) || is_at_open_side(point)) return false;
        const bool near_edge = edges_ && edges_->nearest(point);
        return !near_edge &&
               std::ranges::none_of(surfaces_, [&](const auto& surface) { return surface.nearest(point).has_value(); });
    }

    /// Whether the outside of all fluids is within a distance of a point: their boundary, but not one between two.
    [[nodiscard]] bool end_within(double distance, const Vec& point) const {
        if (is_at_open_side(point)) return false;
        for (int axis = 0; axis < dimension_; ++axis)
            for (const double sign : {-1.0, 1.0})
                if (!hold(point + sign * distance * Vec::Unit(axis))) return true;
        return false;
    }

  private:
    [[nodiscard]] bool is_at_open_side(const Vec& point) const {
        const double near = 1e-3 * box_.extent().maxCoeff();
        for (int axis = 0; axis < dimension_; ++axis)
            if (periodic_.at(static_cast<std::size_t>(axis)) &&
                (point[axis] < box_.low[axis] + near || point[axis] > box_.high[axis] - near))
                return true;
        return false;
    }

    int dimension_;
    std::array<bool, 3> periodic_{};
    Box box_;
    std::vector<InsideTest> areas_;
    std::optional<NearestCurve> edges_;
    std::vector<WindingNumber> solids_;
    std::vector<NearestTriangle> surfaces_;
};

using Visit = std::function<void(const Vec&)>;

void visit_line(const Vec& a, const Vec& b, double step, const Visit& visit) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
    for (int k = 0; k <= pieces; ++k) visit(a + (b - a) * k / pieces);
}

/// Halved along the longest side until that is shorter than a step.
void visit_triangle(const std::array<Vec, 3>& corners, double step, const Visit& visit) {
    std::size_t longest = 0;
    const auto length = [&](std::size_t k) { return (corners.at((k + 1) % 3) - corners.at(k)).norm(); };
    for (const std::size_t k : {1U, 2U})
        if (length(k) > length(longest)) longest = k;
    if (length(longest) <= step) {
        for (const Vec& corner : corners) visit(corner);
        return;
    }
    const Vec middle = 0.5 * (corners.at(longest) + corners.at((longest + 1) % 3));
    std::array<Vec, 3> first = corners, second = corners;
    first.at((longest + 1) % 3) = middle;
    second.at(longest) = middle;
    visit_triangle(first, step, visit);
    visit_triangle(second, step, visit);
}

/// Places of a thin body, half a spacing apart at most; of others none, which take the room of what they meet.
void visit_body(const Geometry& geometry, const Part& part, double spacing, const Visit& visit) {
    if (const CurveSet* curves = geometry.curve_set(part.name))
        for (const Polyline& piece : curves->pieces)
            for (std::size_t k = 0; k + 1 < piece.points.size(); ++k)
                visit_line(piece.points[k], piece.points[k + 1], 0.5 * spacing, visit);
    if (const SurfaceSet* set = geometry.surface_set(part.name))
        for (const auto& [a, b, c] : set->surface.triangles) {
            const auto corner = [&](int k) { return set->surface.corners[static_cast<std::size_t>(k)]; };
            visit_triangle({corner(a), corner(b), corner(c)}, 0.5 * spacing, visit);
        }
}

std::string line_about(const Geometry& geometry, const Fluids& fluids, const Part& part, double spacing) {
    std::size_t within = 0, outside = 0;
    std::optional<Vec> first_outside, first_touching;
    visit_body(geometry, part, spacing, [&](const Vec& point) {
        if (fluids.are_left_behind(point)) {
            ++outside;
            if (!first_outside) first_outside = point;
        } else if (fluids.hold(point)) {
            ++within;
        }
        if (!first_touching && fluids.end_within(touching * spacing, point)) first_touching = point;
    });
    if (within == 0) return {};
    const auto where = [&](const Vec& point) { return position_text(point, geometry.dimension); };
    if (outside > 0)
        return part.name.value + ": it goes through the boundary of the fluid, and is outside near " +
               where(*first_outside) + ": where it moves it opens the wall; let it end on the wall";
    if (first_touching && part.anchor->empty())
        return part.name.value + ": it touches the boundary of the fluid near " + where(*first_touching) +
               " and is held nowhere: fluid passes between; give it an `anchor`, or keep it apart";
    return {};
}

}  // namespace

std::vector<std::string> bodies_through_walls(const Geometry& geometry, const Scene& scene) {
    std::vector<std::string> said;
    const std::vector<const Part*> bodies = scene.parts_of(PartKind::elastic);
    if (bodies.empty() || scene.parts_of(PartKind::fluid).empty()) return said;
    const Fluids fluids(geometry, scene);
    for (const Part* part : bodies)
        if (std::string line = line_about(geometry, fluids, *part, scene.particles.spacing); !line.empty())
            said.push_back(std::move(line));
    return said;
}

}  // namespace dmp::mesher
