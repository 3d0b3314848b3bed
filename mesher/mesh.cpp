// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/mesh.hpp"

#include <cmath>
#include <sstream>

#include "mesher/disorder.hpp"
#include "mesher/names.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/quality.hpp"
#include "mesher/relax.hpp"

namespace dmp {

namespace {

void check_periods(const Scene& scene, const Box& box) {
    const double needed = (scene.accuracy.support + 1) * scene.particles.spacing;
    for (int axis = 0; axis < 2; ++axis) {
        if (!scene.flow.periodic[axis] || box.extent()[axis] >= needed) continue;
        std::ostringstream problem;
        problem << "the period along "
                << "xyz"[axis] << " is " << box.extent()[axis]
                << " m, shorter than the kernel's support plus a spacing, " << needed << " m";
        throw InputError(scene.flow.periodic[axis].place, problem.str(),
                         "draw a longer period or refine particles.spacing");
    }
}

}  // namespace

MeshResult mesh(const Geometry& geometry, const Scene& scene) {
    if (scene.dimension != 2)
        throw InputError(scene.dimension.place, "dimension: found 3, and dmp makes particles from plane drawings only",
                         "3-D is not there yet: write dimension = 2");
    check_names(geometry, scene);
    const Box box = fluid_box(geometry, scene);
    check_periods(scene, box);
    check_boundary(geometry, scene, box);

    ParticleBuilder builder(geometry, scene);
    for (const Part* part : scene.parts_of(PartKind::springs)) builder.add_springs(*part);
    for (const Part* part : scene.parts_of(PartKind::fluid)) builder.add_fluid(*part);
    for (const Part* part : scene.parts_of(PartKind::rigid)) builder.add_walls(*part);
    const Disorder disorder{scene.particles.disorder, static_cast<std::uint64_t>(scene.particles.seed.value)};
    disturb(builder.particles(), disorder,
            [&](std::size_t i, const Vec& point) { return builder.holds(i, point) && builder.clear_of_bodies(point); });
    builder.mark_seated(scene.contact.range * scene.particles.spacing);
    relax_around_bodies(builder.particles(), scene.accuracy.support * scene.particles.spacing,
                        [&](std::size_t i, const Vec& point) { return builder.holds(i, point); });
    MeshResult result = builder.finish();
    if (disorder.amplitude > 0) result.report.notes.push_back(disorder.text());
    measure_quality(result, scene);
    return result;
}

}  // namespace dmp
