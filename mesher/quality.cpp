// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/quality.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

#include "base/length_text.hpp"
#include "base/unlisted_value.hpp"
#include "mesher/searchable_particles.hpp"
#include "mesher/uses.hpp"
#include "models/sph/kernels.hpp"

namespace dmp::mesher {

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
    std::ostringstream problem;
    problem << "particles of '" << name << "' and '" << set.parts[set.part[j]].name
            << "' stand on top of each other at " << position_text(set.position[i], set.dimension);
    throw InputError(
        scene.part_of_particles(name).name.location, problem.str(),
        "refine particles.spacing, or draw them further apart: an elastic solid's rows stand half a spacing "
        "beside what is drawn, so that two of them want " +
            length_text((1 + bodies_too_near) * set.spacing) + " from one to the other");
}

/// What the neighbours of each particle say.
struct Surroundings {
    std::vector<double> kernel_sum;         // SUM V W [-]
    std::vector<float> nearest;             // distance of the nearest other particle, at most the support [m]
    std::vector<std::uint8_t> near_solids;  // 1: one of a wall or a body is within the support
};

template <class Kernel>
Surroundings surroundings(const ParticleSet& set, const Scene& scene, const Kernel& kernel, double support) {
    const SearchableParticles search(set, support, support / 3);
    Surroundings found{std::vector<double>(set.size()), std::vector<float>(set.size()),
                       std::vector<std::uint8_t>(set.size())};
    // What most neighbours are asked is one array; those that nothing can be wrong with are asked no more.
    std::vector<std::uint8_t> is_solid(set.size());
    for (std::size_t i = 0; i < set.size(); ++i) is_solid[i] = set.kind(i) != PartKind::fluid ? 1 : 0;
    const double always_far_enough = std::max(too_near, bodies_too_near) * set.spacing;
    const auto count = static_cast<std::int64_t>(set.size());
    std::int64_t first_overlap = count;
#pragma omp parallel for schedule(dynamic, 4096) reduction(min : first_overlap)
    for (std::int64_t n = 0; n < count; ++n) {
        const auto i = static_cast<std::size_t>(n);
        std::uint8_t near_solids = 0;
        double nearest = support, kernel_sum = set.volume[i] * kernel.value(0.0);
        search.for_each_neighbour(i, [&](std::size_t j, const Vec& separation) {
            const double r = separation.norm();
            nearest = std::min(nearest, r);
            kernel_sum += set.volume[j] * kernel.value(r);
            near_solids |= is_solid[j];
            if (r < always_far_enough && r < smallest_distance(set, i, j)) first_overlap = std::min(first_overlap, n);
        });
        found.near_solids[i] = near_solids;
        found.nearest[i] = static_cast<float>(nearest);
        found.kernel_sum[i] = kernel_sum;
    }
    if (first_overlap == count) return found;
    const auto i = static_cast<std::size_t>(first_overlap);
    search.for_each_neighbour(i, [&](std::size_t j, const Vec& separation) {
        if (separation.norm() < smallest_distance(set, i, j)) refuse_overlap(set, scene, i, j);
    });
    return found;
}

template <int D>
Surroundings surroundings(const ParticleSet& set, const Scene& scene, double support) {
    switch (*scene.numerics.kernel) {
        case KernelKind::wendland_c2:
            return surroundings(set, scene, WendlandC2<D>(support), support);
        case KernelKind::wendland_c4:
            return surroundings(set, scene, WendlandC4<D>(support), support);
        case KernelKind::lucy:
            return surroundings(set, scene, Lucy<D>(support), support);
        case KernelKind::cubic_spline:
            return surroundings(set, scene, CubicSpline<D>(support), support);
        case KernelKind::quintic_spline:
            return surroundings(set, scene, QuinticSpline<D>(support), support);
    }
    unlisted_value(*scene.numerics.kernel);
}

Surroundings surroundings(const ParticleSet& set, const Scene& scene) {
    const double support = scene.numerics.support * scene.particles.spacing;
    return set.dimension == 3 ? surroundings<3>(set, scene, support) : surroundings<2>(set, scene, support);
}

/// Mean and standard deviation of what is added.
class Sums {
  public:
    void add(double value) {
        ++count_;
        sum_ += value;
        squares_ += value * value;
    }
    [[nodiscard]] MeshReport::KernelSums line() const {
        if (count_ == 0) return {};
        const auto count = static_cast<double>(count_);
        const double mean = sum_ / count;
        return {count_, mean, std::sqrt(std::max(0.0, squares_ / count - mean * mean))};
    }

  private:
    std::size_t count_ = 0;
    double sum_ = 0, squares_ = 0;
};

struct PartSums {
    double nearest = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> nearest_counts;
    Sums all, inside, near_walls;
    std::size_t count = 0;
};

std::vector<PartSums> sums_by_part(const ParticleSet& set, const Surroundings& found) {
    std::vector<PartSums> sums(set.parts.size());
    for (std::size_t i = 0; i < set.size(); ++i) {
        PartSums& part = sums[static_cast<std::size_t>(set.part[i])];
        const auto nearest = static_cast<double>(found.nearest[i]);
        part.nearest = std::min(part.nearest, nearest);
        const auto bar = static_cast<std::size_t>(std::lround(nearest / set.spacing / MeshReport::nearest_bar));
        if (part.nearest_counts.size() <= bar) part.nearest_counts.resize(bar + 1);
        ++part.nearest_counts[bar];
        part.all.add(found.kernel_sum[i]);
        (found.near_solids[i] != 0 ? part.near_walls : part.inside).add(found.kernel_sum[i]);
        ++part.count;
    }
    return sums;
}

}  // namespace

void measure_quality(MeshResult& result, const Scene& scene) {
    const ParticleSet& set = result.particles;
    const Surroundings found = surroundings(set, scene);
    result.kernel_sum.assign(found.kernel_sum.begin(), found.kernel_sum.end());
    const auto sums = sums_by_part(set, found);
    result.report.dimension = set.dimension;
    for (const MeshReport::SpringLine& springs : result.report.springs) {
        MeshReport::PartLine line;
        line.name = springs.part;
        line.kind = to_string(PartKind::elastic);
        line.unit = "m";
        result.report.parts.push_back(line);
    }
    for (std::size_t p = 0; p < set.parts.size(); ++p) {
        const auto line = std::find_if(result.report.parts.begin(), result.report.parts.end(),
                                       [&](const MeshReport::PartLine& l) { return l.name == set.parts[p].name; });
        line->nearest = sums[p].nearest / set.spacing;
        line->particles = sums[p].count;
        line->nearest_counts = sums[p].nearest_counts;
        if (set.parts[p].kind != PartKind::fluid) continue;
        const MeshReport::KernelSums all = sums[p].all.line();
        line->kernel_sum_mean = all.mean;
        line->kernel_sum_spread = all.spread;
        line->inside = sums[p].inside.line();
        line->near_walls = sums[p].near_walls.line();
    }
}

}  // namespace dmp::mesher
