// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "models/sph/kernels.hpp"
#include "particles/cell_grid.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// Adds the mirror images of points that lie within reach of a plane of symmetry, axis by axis.
template <int D>
void add_mirror_images(const ParticleSet& set, double reach, Coordinates& points, std::vector<double>& volume) {
    for (int axis = 0; axis < D; ++axis)
        for (const int side : {0, 1}) {
            if (!set.mirrored[axis][side]) continue;
            const double plane = side == 0 ? set.box.low[axis] : set.box.high[axis];
            for (std::size_t i = 0, count = volume.size(); i < count; ++i) {
                if (std::abs(points[axis][i] - plane) > reach) continue;
                for (int other = 0; other < D; ++other) {
                    const double position = points[other][i];
                    points[other].push_back(other == axis ? 2 * plane - position : position);
                }
                volume.push_back(volume[i]);
            }
        }
}

/// By particle: whether it lacks neighbours on one side, if it is of this kind and free; else 0.
template <int D>
std::vector<std::uint8_t> on_surface(const ParticleSet& set, PartKind kind, int threads) {
    const double support = 3 * set.spacing;
    const WendlandC2<D> kernel(support);
    Coordinates points;
    std::vector<double> volume = set.volume;
    for (int axis = 0; axis < D; ++axis)
        for (const Vec& position : set.position)
            points[axis].push_back(set.periodic[axis] ? wrapped(position[axis], set.box.low[axis], set.box.high[axis])
                                                      : position[axis]);
    const auto images = periodic_images(points, set.size(), set.box, set.periodic, support);
    for (const PeriodicImage& image : images) {
        for (int axis = 0; axis < D; ++axis) points[axis].push_back(points[axis][image.source] + image.shift[axis]);
        volume.push_back(set.volume[image.source]);
    }
    add_mirror_images<D>(set, support, points, volume);
    const CellGrid grid(points, volume.size(), D, support);
    const auto count = static_cast<std::ptrdiff_t>(set.size());
    std::vector<std::uint8_t> found(set.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        if (set.kind(static_cast<std::size_t>(i)) != kind || set.fixed[i]) continue;
        std::array<double, 3> position{};
        for (int axis = 0; axis < D; ++axis) position[axis] = points[axis][i];
        double divergence = 0;
        grid.for_each_near(position, support, [&](int j) {
            double r_square = 0;
            for (int axis = 0; axis < D; ++axis) r_square += square(points[axis][j] - position[axis]);
            divergence -= volume[j] * kernel.slope(std::sqrt(r_square)) * r_square;
        });
        found[i] = divergence < 0.75 * D ? 1 : 0;
    }
    return found;
}

std::vector<std::uint8_t> on_surface(const ParticleSet& set, PartKind kind, int threads) {
    return set.dimension == 3 ? on_surface<3>(set, kind, threads) : on_surface<2>(set, kind, threads);
}

}  // namespace

bool has_free_surface(const ParticleSet& set, int threads) {
    return std::ranges::count(on_surface(set, PartKind::fluid, threads), 1) > 0;
}

std::vector<bool> dry_bodies(const ParticleSet& set, int threads) {
    std::vector<bool> dry;
    const auto found = on_surface(set, PartKind::elastic, threads);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (found[i] == 0) continue;
        dry.resize(std::max(dry.size(), static_cast<std::size_t>(set.body[i]) + 1));
        dry[static_cast<std::size_t>(set.body[i])] = true;
    }
    return dry;
}

}  // namespace dmp::solver
