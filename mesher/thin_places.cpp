// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/thin_places.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <sstream>
#include <utility>

#include "base/length_text.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/local_thickness.hpp"
#include "geometry/segments.hpp"
#include "geometry/standing_strips.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/shell_gaps.hpp"
#include "mesher/space_builder.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

namespace {

constexpr double least_gap = 3, least_thickness = 2;  // [spacings]
/// What is nearer touches: there is no gap [spacings].
constexpr double touching = 1e-3;

/// Adds the surface of a body in the fluid, as the fluid has it: facing into the body.
void add_turned(TriangleSurface& to, const TriangleSurface& body) {
    const auto first = static_cast<int>(to.corners.size());
    to.corners.insert(to.corners.end(), body.corners.begin(), body.corners.end());
    for (const auto& [a, b, c] : body.triangles) to.triangles.push_back({first + a, first + c, first + b});
}

/// Lines from one side of the box to the other along an axis in which it is no wall that ends there.
class OpenSides {
  public:
    OpenSides(const Geometry& geometry, const Scene& scene)
        : box_(geometry.dimension == 3 ? fluid_box_in_space(geometry, scene) : fluid_box(geometry, scene)) {
        const auto mirrored = mirrored_sides(scene);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t side = 0; side < 2; ++side)
                open_.at(axis).at(side) = *scene.flow.periodic.at(axis) || mirrored.at(axis).at(side);
    }
    [[nodiscard]] bool holds(const Vec& position) const {
        const double near = 1e-6 * box_.extent().maxCoeff();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<Eigen::Index>(axis);
            if (open_.at(axis)[0] && position[k] < box_.low[k] + near) return true;
            if (open_.at(axis)[1] && position[k] > box_.high[k] - near) return true;
        }
        return false;
    }

  private:
    Box box_;
    std::array<std::array<bool, 2>, 3> open_{};  ///< by axis, low and high
};

/// The line about one part; empty if nothing that counts is thinner than the limit [spacings].
std::string thinnest_text(const LocalThickness& found, double spacing, double limit, const std::string& what,
                          int dimension, const std::function<bool(const ThicknessSample&)>& counts) {
    const ThicknessSample* thinnest = nullptr;
    double area = 0;
    for (const ThicknessSample& sample : found.samples) {
        if (sample.thickness >= (1 - 1e-9) * limit * spacing || !counts(sample)) continue;
        area += sample.area;
        if (thinnest == nullptr || sample.thickness < thinnest->thickness) thinnest = &sample;
    }
    if (thinnest == nullptr) return {};
    std::ostringstream text;
    text.precision(3);
    text << what << " of " << thinnest->thickness / spacing << " spacings near "
         << position_text(0.5 * (thinnest->position + thinnest->opposite), dimension) << ", less than " << limit
         << " particles, as are " << 100 * area / found.area << " % of its " << (dimension == 3 ? "surface" : "edge");
    return text.str();
}

/// What it means for the flow, after the line about a gap.
std::string with_consequence(std::string gap) {
    if (!gap.empty())
        gap += ": flow through it is off by 10 % and more (docs/accuracy.md); take a smaller particles.spacing";
    return gap;
}

/// Edges of fluids in 2-D behind which there is no other fluid.
std::vector<PlaneSegment> edges_of_fluids(const std::vector<const Region*>& fluids, double spacing) {
    std::vector<PlaneSegment> edges;
    std::vector<InsideTest> inside;
    inside.reserve(fluids.size());
    for (const Region* fluid : fluids) inside.emplace_back(*fluid);
    for (const Region* fluid : fluids)
        for_each_segment(*fluid, [&](const Vec& a, const Vec& b) {
            const Vec right = Vec(b.y() - a.y(), a.x() - b.x(), 0).normalized();
            const Vec behind = 0.5 * (a + b) + 1e-3 * spacing * right;
            const bool borders = std::ranges::any_of(
                inside, [&](const InsideTest& other) { return other.side_of(behind) == Side::inside; });
            if (!borders) edges.push_back({a, b});
        });
    return edges;
}

/// Whether something holds the end of a flexible part that is less than a spacing from a wall: its anchor, as
/// ParticleBuilder clamps nodes, or a join.
bool is_held(const Geometry& geometry, const Scene& scene, const Part& part, const Vec& end) {
    const double spacing = scene.particles.spacing;
    if (std::ranges::any_of(scene.joins, [&](const Join& join) {
            return join.parts.value[0] == *part.name || join.parts.value[1] == *part.name;
        }))
        return true;
    const auto points = geometry.points.find(part.anchor);
    if (points != geometry.points.end())
        return std::ranges::any_of(points->second, [&](const Vec& at) { return (at - end).norm() <= 0.51 * spacing; });
    const CurveSet* curves = geometry.curve_set(part.anchor);
    return curves != nullptr && curves->nearest(end).distance <= 0.1 * spacing;
}

/// From the ends of a flexible part to walls and other flexible pieces. A layer of fluid is half a spacing from a wall,
/// and a whole one from a flexible curve.
std::string narrow_tip(const Geometry& geometry, const Scene& scene, const Part& part,
                       const std::vector<PlaneSegment>& edges, const std::function<bool(const Vec&)>& in_fluid) {
    const CurveSet* curve = geometry.curve_set(part.name);
    if (curve == nullptr) return {};  // an area, whose gaps are the fluid's
    const double spacing = scene.particles.spacing;
    double fewest = least_gap * (1 - 1e-9);
    Vec where = Vec::Zero();
    for (const Polyline& piece : curve->pieces)
        for (const Vec& end : {piece.points.front(), piece.points.back()}) {
            Projection wall{.distance = std::numeric_limits<double>::infinity()}, body = wall;
            for (const auto& [a, b] : edges) keep_nearest(wall, end, a, b);
            if (wall.distance <= touching * spacing) continue;  // drawn onto it
            if (wall.distance < spacing && (!in_fluid(end) || is_held(geometry, scene, part, end))) continue;
            for (const Part* other : scene.parts_of(PartKind::elastic))
                if (const CurveSet* curves = geometry.curve_set(other->name))
                    for (const Polyline& others : curves->pieces)
                        if (&others != &piece)
                            for_each_segment(others,
                                             [&](const Vec& a, const Vec& b) { keep_nearest(body, end, a, b); });
            if (body.distance < spacing) continue;  // it is joined to it
            const double particles =
                std::max(0.0, std::min(wall.distance / spacing - 0.5, body.distance / spacing - 1));
            if (particles >= fewest) continue;
            fewest = particles;
            where = end;
        }
    if (fewest >= least_gap * (1 - 1e-9)) return {};
    std::ostringstream text;
    text.precision(3);
    text << part.name.value << ": a gap at its end near " << position_text(where, 2) << " that " << fewest
         << " particles fit into, less than " << least_gap;
    return text.str();
}

/// What lies between fluids, or two borders of one: walls, one line each. `edges`: of fluids, as far as they are no
/// open sides of the box.
std::vector<std::string> thin_walls(const Geometry& geometry, const Scene& scene, std::vector<PlaneSegment> edges,
                                    const std::function<bool(const Vec&)>& is_filled) {
    const double spacing = scene.particles.spacing;
    for (PlaneSegment& edge : edges) std::swap(edge[0], edge[1]);
    const LocalThickness found = local_thickness(standing_strips(edges, spacing), spacing);
    std::vector<std::string> said;
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        const CurveSet& curve = *geometry.curve_set(part->name);
        const auto is_of_part = [&](const ThicknessSample& sample) {
            Vec middle = 0.5 * (sample.position + sample.opposite), on_surface = sample.position;
            middle.z() = on_surface.z() = 0;
            return sample.thickness > touching * spacing && !is_filled(middle) &&
                   curve.nearest(on_surface).distance < touching * spacing;
        };
        std::string line =
            thinnest_text(found, spacing, least_thickness, part->name.value + ": a thickness", 2, is_of_part);
        if (!line.empty())
            line +=
                ", with fluid on both sides, which acts on each other through it; draw it thicker or take a smaller "
                "particles.spacing";
        said.push_back(std::move(line));
    }
    return said;
}

std::vector<std::string> thin_regions_2d(const Geometry& geometry, const Scene& scene) {
    const double spacing = scene.particles.spacing;
    std::vector<std::string> said;
    std::vector<const Region*> fluids;
    for (const Part* part : scene.parts_of(PartKind::fluid)) fluids.push_back(geometry.region(part->name));
    const OpenSides open(geometry, scene);
    const auto is_open = [&](const PlaneSegment& edge) {
        return open.holds(0.5 * (edge[0] + edge[1])) && open.holds(edge[0]) && open.holds(edge[1]);
    };
    std::vector<PlaneSegment> edges = edges_of_fluids(fluids, spacing);
    std::erase_if(edges, is_open);
    const std::vector<PlaneSegment> of_fluids = edges;
    std::vector<InsideTest> in_body;
    for (const Part* part : scene.parts_of(PartKind::elastic)) {
        const Region* body = geometry.region(part->name);
        if (body == nullptr) continue;
        in_body.emplace_back(*body);
        for_each_segment(*body, [&](const Vec& a, const Vec& b) { edges.push_back({b, a}); });
    }
    std::erase_if(edges, is_open);
    const LocalThickness found = local_thickness(standing_strips(edges, spacing), spacing);
    std::vector<InsideTest> in_fluids;
    in_fluids.reserve(fluids.size());
    for (const Region* fluid : fluids) {
        const InsideTest& inside = in_fluids.emplace_back(*fluid);
        said.push_back(with_consequence(
            thinnest_text(found, spacing, least_gap, fluid->name + ": a gap", 2, [&](const ThicknessSample& sample) {
                Vec middle = 0.5 * (sample.position + sample.opposite);
                middle.z() = 0;
                return sample.thickness > touching * spacing && inside.side_of(middle) == Side::inside &&
                       std::ranges::none_of(
                           in_body, [&](const InsideTest& body) { return body.side_of(middle) == Side::inside; });
            })));
    }
    const auto in_fluid = [&](const Vec& point) {
        const auto holds = [&](const InsideTest& area) { return area.side_of(point) == Side::inside; };
        return std::ranges::any_of(in_fluids, holds) && std::ranges::none_of(in_body, holds);
    };
    for (const Part* part : scene.parts_of(PartKind::elastic))
        said.push_back(narrow_tip(geometry, scene, *part, edges, in_fluid));
    const auto is_filled = [&](const Vec& point) {
        const auto holds = [&](const InsideTest& area) { return area.side_of(point) == Side::inside; };
        return std::ranges::any_of(in_fluids, holds) || std::ranges::any_of(in_body, holds);
    };
    std::ranges::move(thin_walls(geometry, scene, of_fluids, is_filled), std::back_inserter(said));
    return said;
}

std::vector<std::string> thin_regions_3d(const Geometry& geometry, const Scene& scene) {
    std::vector<std::string> said;
    const double spacing = scene.particles.spacing;
    const OpenSides open(geometry, scene);
    const auto ends_on_walls = [&](const ThicknessSample& sample) {
        return !open.holds(sample.position) && !open.holds(sample.opposite);
    };
    const ShellGaps shells(geometry, scene, least_gap, [&](const Vec& position) { return open.holds(position); });
    std::vector<TriangleSurface> bodies = shells.bodies();
    for (const PartKind kind : {PartKind::rigid, PartKind::elastic})
        for (const Part* part : scene.parts_of(kind)) {
            const Solid* solid = geometry.solid(part->name);
            if (solid == nullptr) continue;
            bodies.push_back(solid->surface);
            if (kind == PartKind::rigid)
                said.push_back(thinnest_text(local_thickness(solid->surface, spacing), spacing, least_thickness,
                                             part->name.value + ": a thickness", 3, ends_on_walls));
        }
    std::vector<WindingNumber> in_body;
    in_body.reserve(bodies.size());
    for (const TriangleSurface& body : bodies) in_body.emplace_back(body);
    for (const Part* part : scene.parts_of(PartKind::fluid)) {
        TriangleSurface around = geometry.solid(part->name)->surface;
        const WindingNumber in_fluid(around);
        for (const TriangleSurface& body : bodies) add_turned(around, body);
        const auto is_fluid = [&](const ThicknessSample& sample) {
            const Vec middle = 0.5 * (sample.position + sample.opposite);
            return sample.thickness > touching * spacing && ends_on_walls(sample) && in_fluid.inside(middle) &&
                   !shells.is_in_a_wedge(sample) &&
                   std::ranges::none_of(in_body, [&](const WindingNumber& body) { return body.inside(middle); });
        };
        said.push_back(with_consequence(thinnest_text(local_thickness(around, spacing), spacing, least_gap,
                                                      part->name.value + ": a gap", 3, is_fluid)));
    }
    std::ranges::move(shells.narrow_edges(), std::back_inserter(said));
    return said;
}

}  // namespace

std::vector<std::string> thin_regions(const Geometry& geometry, const Scene& scene) {
    std::vector<std::string> said =
        geometry.dimension == 3 ? thin_regions_3d(geometry, scene) : thin_regions_2d(geometry, scene);
    std::erase(said, std::string());
    return said;
}

}  // namespace dmp::mesher
