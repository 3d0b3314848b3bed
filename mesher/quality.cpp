// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "mesher/searchable_particles.hpp"
#include "particles/kernels.hpp"

namespace dmp {

namespace {

/// Particles of different parts nearer than this stand on top of each other [spacings].
constexpr double too_near = 0.4;
/// The same for nodes of two spring bodies: where their curves cross, some are at most 0.74 spacings apart.
constexpr double bodies_too_near = 0.75;

/// How near two particles may stand [m]. A lattice keeps its own distance; a body whose curve folds back does not.
double smallest_distance(const ParticleSet& set, std::size_t i, std::size_t j) {
    if (set.body[i] < 0 && set.part[i] == set.part[j]) return 0;
    const bool two_bodies = set.body[i] >= 0 && set.body[j] >= 0 && set.body[i] != set.body[j];
    return (two_bodies ? bodies_too_near : too_near) * set.spacing;
}

[[noreturn]] void refuse_overlap(const ParticleSet& set, const Scene& scene, std::size_t i, std::size_t j) {
    const std::string& name = set.parts[set.part[i]].name;
    const auto part =
        std::find_if(scene.parts.begin(), scene.parts.end(), [&](const Part& p) { return *p.name == name; });
    std::ostringstream problem;
    problem << "particles of '" << name << "' and '" << set.parts[set.part[j]].name
            << "' stand on top of each other at (" << 1e3 * set.position[i][0] << ", " << 1e3 * set.position[i][1]
            << ") mm";
    throw InputError(
        part->name.place, problem.str(),
        "draw them further apart: the rows of a springs part stand half a particle spacing beside its curve");
}

struct PartSums {
    double nearest = std::numeric_limits<double>::infinity();
    double kernel_sum = 0, kernel_sum_square = 0;
    std::size_t count = 0;
};

template <class Kernel>
std::vector<PartSums> sums_by_part(const ParticleSet& set, const Scene& scene, const Kernel& kernel, double support) {
    std::vector<PartSums> sums(set.parts.size());
    const SearchableParticles search(set, support);
    for (std::size_t i = 0; i < set.size(); ++i) {
        PartSums& part = sums[static_cast<std::size_t>(set.part[i])];
        double nearest = support, kernel_sum = set.volume[i] * kernel.value(0.0);
        search.for_each_neighbour(i, [&](std::size_t j, const Vec& separation) {
            const double r = separation.norm();
            nearest = std::min(nearest, r);
            kernel_sum += set.volume[j] * kernel.value(r);
            if (r < smallest_distance(set, i, j)) refuse_overlap(set, scene, i, j);
        });
        part.nearest = std::min(part.nearest, nearest);
        part.kernel_sum += kernel_sum;
        part.kernel_sum_square += kernel_sum * kernel_sum;
        ++part.count;
    }
    return sums;
}

template <int D>
std::vector<PartSums> sums_by_part(const ParticleSet& set, const Scene& scene, double support) {
    switch (*scene.accuracy.kernel) {
        case KernelKind::wendland_c4:
            return sums_by_part(set, scene, WendlandC4<D>(support), support);
        case KernelKind::lucy:
            return sums_by_part(set, scene, Lucy<D>(support), support);
        case KernelKind::cubic_spline:
            return sums_by_part(set, scene, CubicSpline<D>(support), support);
        case KernelKind::quintic_spline:
            return sums_by_part(set, scene, QuinticSpline<D>(support), support);
        default:
            return sums_by_part(set, scene, WendlandC2<D>(support), support);
    }
}

}  // namespace

void measure_quality(MeshResult& result, const Scene& scene) {
    const ParticleSet& set = result.particles;
    const double support = scene.accuracy.support * scene.particles.spacing;
    const auto sums = set.dimension == 3 ? sums_by_part<3>(set, scene, support) : sums_by_part<2>(set, scene, support);
    for (const MeshReport::SpringLine& springs : result.report.springs) {
        MeshReport::PartLine line;
        line.name = springs.part;
        line.kind = word(PartKind::springs);
        line.unit = "m";
        result.report.parts.push_back(line);
    }
    for (std::size_t p = 0; p < set.parts.size(); ++p) {
        const auto line = std::find_if(result.report.parts.begin(), result.report.parts.end(),
                                       [&](const MeshReport::PartLine& l) { return l.name == set.parts[p].name; });
        line->nearest = sums[p].nearest / set.spacing;
        line->particles = sums[p].count;
        if (set.parts[p].kind != ParticleKind::fluid) continue;
        const auto count = static_cast<double>(sums[p].count);
        line->kernel_sum_mean = sums[p].kernel_sum / count;
        line->kernel_sum_spread =
            std::sqrt(std::max(0.0, sums[p].kernel_sum_square / count - line->kernel_sum_mean * line->kernel_sum_mean));
    }
}

}  // namespace dmp
