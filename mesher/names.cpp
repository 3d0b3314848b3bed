// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/names.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "base/length_text.hpp"
#include "base/nearest_name.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/nearest_curve.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

namespace {

/// What the geometry has under this name, in words; empty when nothing.
std::string kind_in_geometry(const Geometry& geometry, const std::string& name) {
    if (geometry.solid(name) != nullptr) return "a volume";
    if (geometry.region(name) != nullptr || geometry.surface_set(name) != nullptr) return "a surface";
    if (geometry.curve_set(name) != nullptr) return "a curve";
    return geometry.points.contains(name) ? "a point" : "";
}

[[noreturn]] void missing(const Geometry& geometry, const Value<std::string>& name, const std::string& wanted) {
    const std::string found = kind_in_geometry(geometry, name);
    const auto names = geometry.names();
    const std::string near = nearest_name(name.value, names);
    const SurfaceSet* set = geometry.surface_set(name);
    const std::string why = set != nullptr && !set->why_open.empty() ? "; " + set->why_open : "";
    const std::string problem = found.empty() ? "the geometry has nothing named '" + name.value + "'"
                                              : "'" + name.value + "' is " + found + " in the geometry, but " + wanted +
                                                    " is needed here" + why;
    throw InputError(name.location, problem + " (" + geometry.file + ")",
                     "it names " + quoted_list(names) +
                         (near.empty() || near == name.value ? "" : "; did you mean '" + near + "'?"));
}

bool on_side_that_goes_on(const Vec& a, const Vec& b, const Scene& scene, const Box& box, double tolerance) {
    const auto mirrored = mirrored_sides(scene);
    for (int axis = 0; axis < 2; ++axis)
        for (const bool high : {false, true}) {
            if (!scene.flow.periodic[axis] && !mirrored[axis][high ? 1 : 0]) continue;
            const double side = (high ? box.high : box.low)[axis];
            if (std::abs(a[axis] - side) < tolerance && std::abs(b[axis] - side) < tolerance) return true;
        }
    return false;
}

/// The whole side must look alike on both ends of the period.
void check_sides_match(const Region& region, const Part& part, int axis, const Box& box, double spacing) {
    const InsideTest inside(region);
    const int other = 1 - axis;
    const double step = 0.25 * spacing;
    const auto positions = static_cast<long>(std::ceil(box.extent()[other] / step));
    for (long k = 0; k < positions; ++k) {
        const double along = box.low[other] + (static_cast<double>(k) + 0.5) * step;
        Vec low = Vec::Zero(), high = Vec::Zero();
        low[axis] = box.low[axis] + 1e-3 * spacing;
        high[axis] = box.high[axis] - 1e-3 * spacing;
        low[other] = high[other] = along;
        if ((inside.side_of(low) == Side::inside) == (inside.side_of(high) == Side::inside)) continue;
        const bool low_is_in = inside.side_of(low) == Side::inside;
        throw InputError(part.name.location,
                         "the periodic sides of '" + part.name.value +
                             "' do not match: " + position_text(low_is_in ? low : high, 2) + " is fluid, " +
                             position_text(low_is_in ? high : low, 2) + " is not",
                         "draw both ends of the period alike, or take the axis out of flow.periodic");
    }
}

/// An area of springs is of a material, a curve of them a strip.
void check_elastic_2d(const Geometry& geometry, const Part& part) {
    const bool is_area = geometry.region(part.name) != nullptr, is_curve = geometry.curve_set(part.name) != nullptr;
    if (!is_area && !is_curve) missing(geometry, part.name, "a curve or a surface");
    if (is_area && !part.density.given())
        throw InputError(part.mass_per_length.location,
                         "part '" + part.name.value +
                             "' is a surface in the geometry, a solid of springs, which has no "
                             "mass_per_length",
                         "give its density, youngs_modulus and poisson_ratio, or draw its middle line as a curve");
    if (!is_area && part.density.given())
        throw InputError(
            part.density.location,
            "part '" + part.name.value + "' is a curve in the geometry, a strip of springs, which has no density",
            "give its mass_per_length: density times thickness times 1 m");
}

void need_in_plane(const Geometry& geometry, const Part& part) {
    if (part.kind.value == PartKind::fluid) {
        if (geometry.region(part.name) == nullptr) missing(geometry, part.name, "a surface for a fluid");
    } else if (part.kind.value == PartKind::elastic) {
        check_elastic_2d(geometry, part);
    } else if (geometry.curve_set(part.name) == nullptr) {
        missing(geometry, part.name, "a curve");
    }
}

void need_in_space(const Geometry& geometry, const Part& part) {
    if (part.kind.value == PartKind::fluid) {
        if (geometry.solid(part.name) == nullptr) missing(geometry, part.name, "a volume for a fluid");
        return;
    }
    if (geometry.solid(part.name) == nullptr && geometry.surface_set(part.name) == nullptr)
        missing(geometry, part.name, "a surface or a volume");
    if (part.kind.value != PartKind::elastic) return;
    const bool is_shell = geometry.solid(part.name) == nullptr;
    if (is_shell && !part.thickness.given())
        throw InputError(part.name.location,
                         "part '" + part.name.value +
                             "' is a surface in the geometry, a shell of springs: its thickness "
                             "is missing",
                         "add thickness, such as thickness = \"0.3 mm\"");
    if (!is_shell && part.thickness.given())
        throw InputError(part.thickness.location,
                         "part '" + part.name.value + "' is a volume in the geometry: it is as thick as it is drawn",
                         "take `thickness` out, or draw a surface to make it a shell");
}

}  // namespace

void check_names(const Geometry& geometry, const Scene& scene) {
    std::set<std::string> used;
    for (const Selection& selection : scene.selections) used.insert({*selection.name, *selection.of});
    for (const Part& part : scene.parts) {
        used.insert(part.name);
        if (!part.anchor->empty()) used.insert(part.anchor);
        if (!part.enabled) continue;
        if (geometry.dimension == 3)
            need_in_space(geometry, part);
        else
            need_in_plane(geometry, part);
        if (part.anchor->empty()) continue;
        if (geometry.dimension == 3) {
            if (geometry.solid(part.anchor) == nullptr && geometry.surface_set(part.anchor) == nullptr)
                missing(geometry, part.anchor, "a surface or a volume");
        } else if (!geometry.points.contains(part.anchor) && geometry.curve_set(part.anchor) == nullptr) {
            missing(geometry, part.anchor, "a point or a curve");
        }
    }
    for (const std::string& name : geometry.names()) {
        if (used.contains(name)) continue;
        const std::vector<std::string> parts(used.begin(), used.end());
        const std::string near = nearest_name(name, parts);
        throw InputError(
            scene.geometry.file.location,
            "the geometry names " + kind_in_geometry(geometry, name) + " '" + name +
                "' that no part of the scene uses (" + geometry.file + ")",
            "add a [[part]] with this name (enabled = false leaves it out), or take the name out of the geometry" +
                (near.empty() ? "" : "; the scene has '" + near + "'"));
    }
}

InputError sheet_as_border(const Part& fluid, const Part& sheet, const Vec& where, int dimension) {
    const bool in_space = dimension == 3;
    return {sheet.name.location,
            "'" + sheet.name.value + "' is the border of '" + fluid.name.value + "' near " +
                position_text(where, dimension) + ", with nothing behind it: the two layers of nodes of a " +
                (in_space ? "shell" : "strip") + " move in liquid, and close none in",
            in_space ? "draw it as a volume of two spacings or more, with density and without thickness, or draw the "
                       "liquid on both sides of it, as far as a wall"
                     : "draw it as an area of two spacings or more, with density in place of mass_per_length and "
                       "thickness, or draw the liquid on both sides of it, as far as a wall"};
}

void check_boundary(const Geometry& geometry, const Scene& scene, const Box& box) {
    const double spacing = scene.particles.spacing;
    const double tolerance = 1e-3 * spacing;
    std::vector<NearestCurve> walls;
    for (const Part* part : scene.parts_of(PartKind::rigid))
        walls.emplace_back(*geometry.curve_set(part->name), 2 * tolerance);
    std::vector<const Region*> regions;
    for (const PartKind kind : {PartKind::fluid, PartKind::elastic})
        for (const Part* part : scene.parts_of(kind))
            if (const Region* region = geometry.region(part->name)) regions.push_back(region);

    const auto at_wall = [&](const Vec& p) {
        return std::any_of(walls.begin(), walls.end(),
                           [&](const NearestCurve& wall) { return wall.nearest(p).has_value(); });
    };
    // Looked for on both sides of the border: the middle of a chord that two areas share need not be on it to the last
    // bit.
    const auto at_another_area = [&](const Vec& p, const Vec& along, const Region* own) {
        const Vec aside = tolerance * Vec(-along[1], along[0], 0).normalized();
        return std::any_of(regions.begin(), regions.end(), [&](const Region* region) {
            return region != own &&
                   (region->side_of(p + aside) != Side::outside || region->side_of(p - aside) != Side::outside);
        });
    };
    for (const Part* part : scene.parts_of(PartKind::fluid)) {
        const Region& region = *geometry.region(part->name);
        for (const Polyline& loop : region.loops)
            for (std::size_t k = 0; k < loop.points.size(); ++k) {
                const Vec& a = loop.points[k];
                const Vec& b = loop.points[(k + 1) % loop.points.size()];
                // A solid that is drawn over the fluid need not end where this side does.
                const int positions = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
                bool closed = on_side_that_goes_on(a, b, scene, box, tolerance);
                for (int n = 0; n < positions && !closed; ++n) {
                    const Vec position = a + (n + 0.5) / positions * (b - a);
                    if (!at_wall(position) && !at_another_area(position, b - a, &region)) break;
                    closed = n + 1 == positions;
                }
                if (closed) continue;
                for (const Part* sheet : scene.parts_of(PartKind::elastic))
                    if (const CurveSet* curve = geometry.curve_set(sheet->name))
                        if (curve->nearest(0.5 * (a + b)).distance < 2 * tolerance)
                            throw sheet_as_border(*part, *sheet, 0.5 * (a + b), 2);
                throw InputError(part->name.location,
                                 "the boundary of '" + part->name.value + "' is open between " + position_text(a, 2) +
                                     " and " + position_text(b, 2) + ": no rigid part and no periodic side closes it",
                                 "name this curve in the geometry as part of a rigid part, or make the axis periodic "
                                 "(flow.periodic), or the side a plane of symmetry (flow.symmetry)");
            }
        for (int axis = 0; axis < 2; ++axis)
            if (scene.flow.periodic[axis]) check_sides_match(region, *part, axis, box, spacing);
    }
}

}  // namespace dmp::mesher
