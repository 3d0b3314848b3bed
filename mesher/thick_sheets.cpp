// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/thick_sheets.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>

#include "base/length_text.hpp"
#include "geometry/nearest_curve.hpp"
#include "geometry/nearest_triangle.hpp"

namespace dmp::mesher {

namespace {

/// What is nearest lies across a sheet where the way there is within about 37 degrees of its normal [-].
constexpr double across = 0.8;
/// Held places count as such up to here [thicknesses].
constexpr double held_within = 2;

/// Something a sheet may reach into: a place of it that is near a point, if any is as near as asked for.
struct Beside {
    std::string name;
    double half = 0;  ///< of its own thickness [m]
    std::function<std::optional<Vec>(const Vec& point)> nearest;
};

/// A place of a sheet.
struct Place {
    Vec position, normal;
};

std::vector<Place> places_of(const Geometry& geometry, const Part& part, double spacing) {
    std::vector<Place> places;
    if (const SurfaceSet* set = geometry.dimension == 3 ? geometry.surface_set(part.name) : nullptr) {
        for (const auto& [a, b, c] : set->surface.triangles) {
            const auto corner = [&](int k) -> const Vec& { return set->surface.corners[static_cast<std::size_t>(k)]; };
            const Vec turned = (corner(b) - corner(a)).cross(corner(c) - corner(a));
            if (turned.norm() > 0) places.push_back({(corner(a) + corner(b) + corner(c)) / 3, turned.normalized()});
        }
        return places;
    }
    if (const CurveSet* set = geometry.curve_set(part.name))
        for (const Polyline& piece : set->pieces) {
            const auto count = static_cast<int>(std::ceil(piece.length() / spacing));
            for (int n = 0; n < count; ++n) {
                const auto [point, tangent] = piece.at((n + 0.5) / count * piece.length());
                places.push_back({point, Vec(-tangent[1], tangent[0], 0)});
            }
        }
    return places;
}

std::function<std::optional<Vec>(const Vec&)> search(const TriangleSurface& surface, double reach) {
    return [near = std::make_shared<NearestTriangle>(surface, reach)](const Vec& point) -> std::optional<Vec> {
        const auto found = near->nearest(point);
        return found ? std::optional<Vec>(found->point) : std::nullopt;
    };
}
std::function<std::optional<Vec>(const Vec&)> search(const CurveSet& curves, double reach) {
    return [near = std::make_shared<NearestCurve>(curves, reach)](const Vec& point) -> std::optional<Vec> {
        const auto found = near->nearest(point);
        return found ? std::optional<Vec>(found->point) : std::nullopt;
    };
}

/// What is under a name in the geometry, but for the points.
std::function<std::optional<Vec>(const Vec&)> search(const Geometry& geometry, const std::string& name, double reach) {
    if (geometry.dimension == 3) {
        if (const Solid* solid = geometry.solid(name)) return search(solid->surface, reach);
        if (const SurfaceSet* set = geometry.surface_set(name)) return search(set->surface, reach);
        return {};
    }
    if (const Region* region = geometry.region(name)) {
        CurveSet border;
        border.pieces = region->loops;
        return search(border, reach);
    }
    if (const CurveSet* curves = geometry.curve_set(name)) return search(*curves, reach);
    return {};
}

/// Whether a place is that near to where a sheet is held: its anchor, or in 2-D an end of it that something touches.
bool is_held(const Geometry& geometry, const Part& part, const std::vector<Beside>& others,
             const std::function<std::optional<Vec>(const Vec&)>& anchor, const Vec& position, double within) {
    if (const auto points = geometry.points.find(part.anchor); points != geometry.points.end())
        if (std::ranges::any_of(points->second, [&](const Vec& at) { return (at - position).norm() < within; }))
            return true;
    if (anchor && anchor(position)) return true;
    const CurveSet* curves = geometry.dimension == 2 ? geometry.curve_set(part.name) : nullptr;
    if (curves == nullptr) return false;
    for (const Polyline& piece : curves->pieces)
        for (const Vec& end : {piece.points.front(), piece.points.back()}) {
            if ((end - position).norm() >= within) continue;
            for (const Beside& other : others)
                if (const auto found = other.nearest(end); found && (*found - end).norm() < 0.05 * within) return true;
        }
    return false;
}

}  // namespace

std::vector<std::string> thick_sheets(const Geometry& geometry, const Scene& scene) {
    std::vector<std::string> said;
    const auto parts = scene.parts_of(PartKind::elastic);
    double thickest = 0;
    for (const Part* part : parts) thickest = std::max(thickest, *part->thickness);
    for (const Part* part : parts) {
        const double half = part->thickness / 2;
        const bool is_drawn_thick =
            geometry.dimension == 3 ? geometry.solid(part->name) != nullptr : geometry.region(part->name) != nullptr;
        if (!(half > 0) || is_drawn_thick) continue;
        std::vector<Beside> others;
        for (const PartKind kind : {PartKind::rigid, PartKind::elastic})
            for (const Part* other : scene.parts_of(kind))
                if (other != part)
                    if (auto near = search(geometry, other->name, thickest))
                        others.push_back({*other->name, *other->thickness / 2, std::move(near)});
        const double held = held_within * 2 * half;
        const auto anchor = part->anchor->empty() ? nullptr : search(geometry, part->anchor, held);
        double deepest = 1e-6 * half;
        Vec where = Vec::Zero();
        const Beside* into = nullptr;
        for (const auto& [position, normal] : places_of(geometry, *part, scene.particles.spacing))
            for (const Beside& other : others) {
                const auto found = other.nearest(position);
                if (!found) continue;
                const Vec way = *found - position;
                const double depth = half + other.half - way.norm();
                if (depth <= deepest || std::abs(way.dot(normal)) < across * way.norm()) continue;
                if (is_held(geometry, *part, others, anchor, position, held)) continue;
                deepest = depth;
                where = position;
                into = &other;
            }
        if (into == nullptr) continue;
        std::ostringstream text;
        text << part->name.value << ": its thickness of " << length_text(2 * half) << " reaches "
             << length_text(deepest) << " into '" << into->name << "' near " << position_text(where, geometry.dimension)
             << "; draw it farther away, or give it less thickness";
        said.push_back(text.str());
    }
    return said;
}

}  // namespace dmp::mesher
