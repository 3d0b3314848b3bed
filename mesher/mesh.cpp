// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "base/length_text.hpp"
#include "mesher/body_surfaces.hpp"
#include "mesher/bond_report.hpp"
#include "mesher/bonded_solids.hpp"
#include "mesher/contact_surfaces.hpp"
#include "mesher/disorder.hpp"
#include "mesher/join_parts.hpp"
#include "mesher/names.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/quality.hpp"
#include "mesher/relax.hpp"
#include "mesher/single_rows.hpp"
#include "mesher/space_builder.hpp"
#include "mesher/stopwatch.hpp"
#include "mesher/thick_sheets.hpp"
#include "mesher/thin_places.hpp"
#include "mesher/through_walls.hpp"

namespace dmp::mesher {

namespace {

void check_periods(const Scene& scene, const Box& box) {
    const double needed = (scene.numerics.support + 1) * scene.particles.spacing;
    for (int axis = 0; axis < scene.dimension; ++axis) {
        if (!scene.flow.periodic[axis] || box.extent()[axis] >= needed) continue;
        std::ostringstream problem;
        problem << "the period along "
                << "xyz"[axis] << " is " << length_text(box.extent()[axis])
                << ", shorter than the kernel's support plus a spacing, " << length_text(needed);
        throw InputError(scene.flow.periodic[axis].location, problem.str(),
                         "draw a longer period or refine particles.spacing");
    }
}

void check_dimension(const Geometry& geometry, const Scene& scene) {
    if (geometry.dimension == scene.dimension) return;
    const bool in_space = geometry.dimension == 3;
    throw InputError(scene.dimension.given() ? scene.dimension.location : scene.geometry.file.location,
                     std::string("the geometry ") + (in_space ? "has volumes" : "lies in 2-D") +
                         ", and the scene has " + std::to_string(*scene.dimension) + " dimensions (" + geometry.file +
                         ")",
                     "write dimension = " + std::to_string(geometry.dimension) + ", or name another geometry");
}

MeshResult mesh_in_space(const Geometry& geometry, const Scene& scene) {
    if (*scene.particles.disorder > 0)
        throw InputError(scene.particles.disorder.location,
                         "particles.disorder: lattices in 3-D cannot be disturbed yet", "leave it out");
    check_periods(scene, fluid_box_in_space(geometry, scene));
    MeshReport::Cost cost;
    Stopwatch monitor(cost);
    SpaceBuilder builder(geometry, scene);
    monitor.lap("lattice");
    builder.sort_triangles();
    monitor.lap("nearest triangles");
    builder.check_boundary();
    builder.leave_out_hidden_faces();
    monitor.lap("boundary");
    for (const Part* part : scene.parts_of(PartKind::elastic)) builder.add_elastic(*part);
    monitor.lap("elastic");
    for (const Part* part : scene.parts_of(PartKind::fluid)) builder.add_fluid(*part);
    monitor.lap("fluids");
    for (const Part* part : scene.parts_of(PartKind::rigid)) builder.add_walls(*part);
    monitor.lap("walls");
    cost.candidates = builder.candidates();
    mark_seated(builder.particles(), scene.contact.range * scene.particles.spacing);
    if (*scene.particles.fill == FillKind::sampled) builder.sample();
    if (is_fitted(scene.particles.fill)) {
        builder.fit();
        mark_seated(builder.particles(), scene.contact.range * scene.particles.spacing);  // walls and solids moved
    } else
        relax_around_bodies(builder.particles(), scene.numerics.support * scene.particles.spacing,
                            [&](std::size_t, const Vec& point) { return builder.may_stand(point); });
    monitor.lap("fit");
    const std::vector<Sheet> sheets = builder.sheets();
    MeshResult result = builder.finish();
    refuse_single_rows(result.particles, scene);
    measure_quality(result, scene);
    find_body_surfaces(geometry, scene, sheets, result);
    draw_contact_surfaces(geometry, scene, sheets, result.particles);
    bond_solids(result, geometry, scene);
    join_parts(result, scene);
    count_bonds(result);
    monitor.lap("quality");
    std::ranges::move(bodies_through_walls(geometry, scene), std::back_inserter(result.report.warnings));
    std::ranges::move(thin_regions(geometry, scene), std::back_inserter(result.report.warnings));
    std::ranges::move(thick_sheets(geometry, scene), std::back_inserter(result.report.warnings));
    monitor.lap("thin places");
    result.report.cost = cost;
    return result;
}

/// Elastic parts that are curves.
std::vector<Sheet> strips_of(const Geometry& geometry, const Scene& scene) {
    std::vector<Sheet> strips;
    for (const Part* part : scene.parts_of(PartKind::elastic))
        if (geometry.region(part->name) == nullptr)
            strips.push_back({part, strip_thickness(*part, scene), *geometry.curve_set(part->name)});
    return strips;
}

}  // namespace

MeshResult mesh(const Geometry& geometry, const Scene& scene) {
    check_dimension(geometry, scene);
    check_names(geometry, scene);
    if (scene.dimension == 3) return mesh_in_space(geometry, scene);
    const Box box = fluid_box(geometry, scene);
    check_periods(scene, box);
    check_boundary(geometry, scene, box);

    MeshReport::Cost cost;
    Stopwatch monitor(cost);
    ParticleBuilder builder(geometry, scene);
    for (const Part* part : scene.parts_of(PartKind::elastic)) builder.add_elastic(*part);
    monitor.lap("elastic");
    for (const Part* part : scene.parts_of(PartKind::fluid)) builder.add_fluid(*part);
    monitor.lap("fluids");
    for (const Part* part : scene.parts_of(PartKind::rigid)) builder.add_walls(*part);
    monitor.lap("walls");
    const Disorder disorder{scene.particles.disorder, static_cast<std::uint64_t>(scene.particles.seed.value)};
    disturb(builder.particles(), disorder,
            [&](std::size_t i, const Vec& point) { return builder.holds(i, point) && builder.clear_of_bodies(point); });
    mark_seated(builder.particles(), scene.contact.range * scene.particles.spacing);
    if (*scene.particles.fill == FillKind::sampled) builder.sample();
    if (is_fitted(scene.particles.fill)) {
        builder.fit();
        mark_seated(builder.particles(), scene.contact.range * scene.particles.spacing);  // walls and solids moved
    } else
        relax_around_bodies(builder.particles(), scene.numerics.support * scene.particles.spacing,
                            [&](std::size_t i, const Vec& point) { return builder.holds(i, point); });
    cost.candidates = builder.candidates();
    MeshResult result = builder.finish();
    refuse_single_rows(result.particles, scene);
    if (disorder.amplitude > 0) result.report.notes.push_back(disorder.text());
    monitor.lap("moves");
    measure_quality(result, scene);
    const std::vector<Sheet> strips = strips_of(geometry, scene);
    find_body_surfaces(geometry, scene, strips, result);
    draw_contact_surfaces(geometry, scene, strips, result.particles);
    bond_solids(result, geometry, scene);
    join_parts(result, scene);
    count_bonds(result);
    monitor.lap("quality");
    std::ranges::move(bodies_through_walls(geometry, scene), std::back_inserter(result.report.warnings));
    std::ranges::move(thin_regions(geometry, scene), std::back_inserter(result.report.warnings));
    std::ranges::move(thick_sheets(geometry, scene), std::back_inserter(result.report.warnings));
    monitor.lap("thin places");
    result.report.cost = cost;
    return result;
}

}  // namespace dmp::mesher
