// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/geometry_size.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "base/length_text.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "geometry/surface_box.hpp"

namespace dmp::cli {

namespace {

/// Of the lattice around a geometry; on both its sides together [spacings].
constexpr double most_points = 1e11, margin = 12;
/// Of a lattice in 3-D before it has particles; in 2-D nearly all points are particles.
constexpr double bytes_in_space = 2, bytes_in_plane = 100;

Box box_of(const std::vector<Vec>& points) {
    Box box{points.front(), points.front()};
    for (const Vec& point : points) {
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
    }
    return box;
}

/// Of what the geometry has under this name besides points; none: nothing.
std::optional<Box> box_of(const Geometry& geometry, const std::string& name) {
    std::vector<Vec> points;
    const auto add = [&](const std::vector<Polyline>& lines) {
        for (const Polyline& line : lines) points.insert(points.end(), line.points.begin(), line.points.end());
    };
    if (const Solid* solid = geometry.solid(name)) return geometry::box_of(solid->surface);
    if (const SurfaceSet* set = geometry.surface_set(name)) return geometry::box_of(set->surface);
    if (const Region* region = geometry.region(name))
        add(region->loops);
    else if (const CurveSet* curves = geometry.curve_set(name))
        add(curves->pieces);
    return points.empty() ? std::nullopt : std::optional(box_of(points));
}

std::string unit_advice(const Geometry& geometry) {
    return geometry.unit_source == UnitSource::file
               ? "check the unit that the geometry states, and particles.spacing"
               : fmt::format("check geometry.unit (one unit of the geometry is {} now) and particles.spacing",
                             length_text(geometry.unit));
}

/// Curves and surfaces may be short: layers stand behind them all the same.
void check_part(const Geometry& geometry, const Part& part, const Box& box, double spacing) {
    const bool has_room = geometry.solid(part.name) != nullptr || geometry.region(part.name) != nullptr;
    if (!has_room || box.extent().norm() >= spacing) return;
    throw InputError(part.name.location,
                     fmt::format("'{}' is smaller than a particle: it is {} large, around {}, "
                                 "and particles are {} apart",
                                 part.name.value, extent_text(box, geometry.dimension),
                                 position_text(0.5 * (box.low + box.high), geometry.dimension), length_text(spacing)),
                     unit_advice(geometry) + ", or leave the part out (enabled = false)");
}

void check_lattice(const Geometry& geometry, const Scene& scene, const Box& box) {
    const double spacing = scene.particles.spacing;
    double points = 1;
    for (int axis = 0; axis < geometry.dimension; ++axis) points *= box.extent()[axis] / spacing + margin;
    const std::string problem = fmt::format(
        "the geometry is {} large and particles are {} apart: that is a lattice of "
        "{:.2g} points ({})",
        extent_text(box, geometry.dimension), length_text(spacing), points, geometry.file);
    if (points > most_points) throw InputError(scene.particles.spacing.location, problem, unit_advice(geometry));
    const double bytes = points * (geometry.dimension == 3 ? bytes_in_space : bytes_in_plane);
    const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (memory > 0 && bytes > memory)
        throw ResourceError(
            problem + fmt::format(", which takes {}, and this machine has {}", bytes_text(bytes), bytes_text(memory)),
            unit_advice(geometry));
}

}  // namespace

void check_geometry_size(const Geometry& geometry, const Scene& scene) {
    std::optional<Box> fluids;
    for (const Part& part : scene.parts) {
        const auto box = part.enabled ? box_of(geometry, part.name) : std::nullopt;
        if (!box) continue;
        check_part(geometry, part, *box, scene.particles.spacing);
        if (part.kind.value != PartKind::fluid) continue;
        if (fluids)
            fluids = Box{fluids->low.cwiseMin(box->low), fluids->high.cwiseMax(box->high)};
        else
            fluids = box;
    }
    check_lattice(geometry, scene, fluids.value_or(geometry.box));
}

}  // namespace dmp::cli
