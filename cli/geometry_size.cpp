// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/geometry_size.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "base/length_text.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "geometry/surface_box.hpp"

namespace dmp::cli {

namespace {

/// Of the lattice around a geometry; on both its sides together [spacings].
constexpr double most_points = 1e11, many_points = 3e7, margin = 12;
/// Of a point of a lattice in 3-D before it has particles, and of a particle; in 2-D nearly all points are particles.
constexpr double bytes_in_space = 2, bytes_of_particle = 100;

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

void refuse_beyond_memory(double bytes, const std::string& problem, const std::string& what_to_do) {
    const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (memory > 0 && bytes > memory)
        throw ResourceError(
            problem + fmt::format(", which takes {}, and this machine has {}", bytes_text(bytes), bytes_text(memory)),
            what_to_do);
}

void check_lattice(const Geometry& geometry, const Scene& scene, const Box& box) {
    const double spacing = scene.particles.spacing;
    const auto points_with = [&](double around) {
        double points = 1;
        for (int axis = 0; axis < geometry.dimension; ++axis) points *= box.extent()[axis] / spacing + around;
        return points;
    };
    const double points = points_with(margin), each = geometry.dimension == 3 ? bytes_in_space : bytes_of_particle;
    const std::string problem = fmt::format(
        "the geometry is {} large and particles are {} apart: that is a lattice of "
        "{:.2g} points ({})",
        extent_text(box, geometry.dimension), length_text(spacing), points, geometry.file);
    if (points > most_points) throw InputError(scene.particles.spacing.location, problem, unit_advice(geometry));
    refuse_beyond_memory(points * each, problem, unit_advice(geometry));
    if (points > many_points)
        print_error(Style(Stream::error).warning("note: ") + problem + "; making the particles takes minutes\n");

    for (const Part* wall : scene.parts_of(PartKind::rigid)) {
        const double with_layers = points_with(margin + 2.0 * *wall->layers);
        const std::string of_layers =
            fmt::format("{} layers of '{}' around a geometry of {} are a lattice of {:.2g} points", *wall->layers,
                        *wall->name, extent_text(box, geometry.dimension), with_layers);
        const std::string advice =
            fmt::format("give as many layers as the kernel reaches, {:.0f}", std::ceil(*scene.numerics.support));
        if (with_layers > most_points) throw InputError(wall->layers.location, of_layers, advice);
        refuse_beyond_memory(with_layers * each, of_layers, advice);
    }
}

/// In 3-D the particles of the fluids take more than the lattice.
void check_particles(const Geometry& geometry, const Scene& scene) {
    double volume = 0;
    for (const Part* fluid : scene.parts_of(PartKind::fluid))
        if (const Solid* solid = geometry.solid(*fluid->name)) volume += solid->volume();
    const double particles = volume / std::pow(*scene.particles.spacing, 3);
    refuse_beyond_memory(
        particles * bytes_of_particle,
        fmt::format("the fluids take {:.2g} particles, {} apart", particles, length_text(scene.particles.spacing)),
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
    check_particles(geometry, scene);
}

}  // namespace dmp::cli
