// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/inspect.hpp"

#include <algorithm>
#include <limits>

#include "mesher/layers.hpp"
#include "mesher/leak_test.hpp"
#include "mesher/stopwatch.hpp"
#include "mesher/surface_error.hpp"

namespace dmp::mesher {

MeshDetail inspect(MeshResult& result, const Geometry& geometry, const Scene& scene) {
    const ParticleSet& set = result.particles;
    MeshReport& report = result.report;
    MeshDetail detail;
    Stopwatch monitor(report.cost);
    detail.kernel_sum = result.kernel_sum;
    detail.surface_error.assign(set.size(), std::numeric_limits<float>::quiet_NaN());
    const SearchableParticles search(set, surface_search * set.spacing, set.spacing);
    LayerCount layers(set, scene, search);
    for (const Part* fluid : scene.parts_of(PartKind::fluid)) {
        const int number = set.part_named(fluid->name);
        const CadSurface surface(geometry, scene, set, *fluid, 1.01 * set.spacing);
        report.surfaces.push_back(surface_error(set, search, surface, number, detail.surface_error));
        layers.add(surface, number);
    }
    report.layers = layers.lines();
    monitor.lap("surfaces");
    report.leaks = find_leaks(set);
    monitor.lap("leak test");
    return detail;
}

}  // namespace dmp::mesher
