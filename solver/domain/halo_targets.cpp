// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/halo_targets.hpp"

#include <cmath>

namespace dmp::solver {

namespace {

/// Relative margin: distances have rounding errors from coordinates up to a million times as large, but a particle at
/// exactly the reach must be found.
constexpr double margin = 1e-9;

bool is_empty(const Box& box, int dimension) {
    for (int axis = 0; axis < dimension; ++axis)
        if (box.low[axis] > box.high[axis]) return true;
    return false;
}

/// One axis of an image.
struct AxisImage {
    double shift = 0;
    bool mirrored = false;
};

/// Distance between one side of a box in its image and the same side of the other box.
double apart(double low, double high, const AxisImage& image, double other_low, double other_high) {
    const double image_low = (image.mirrored ? -high : low) + image.shift;
    const double image_high = (image.mirrored ? -low : high) + image.shift;
    return std::max({0.0, other_low - image_high, image_low - other_high});
}

/// All images along an axis in which `own` may come within the reach of `other`, mirrored and moved by whole periods.
/// An axis with two planes of symmetry has a period of twice their distance.
std::vector<AxisImage> images_between(const Box& own, const Box& other, const ParticleSpace& space, int axis,
                                      double reach) {
    const double low = space.box.low[axis], high = space.box.high[axis];
    const auto [at_low, at_high] = space.mirrored[axis];
    std::vector<AxisImage> at_home{{0, false}};
    if (at_low || at_high) at_home.push_back({2 * (at_low ? low : high), true});
    const double period = space.periodic[axis] ? high - low : at_low && at_high ? 2 * (high - low) : 0;
    if (period == 0) return at_home;

    std::vector<AxisImage> images;
    for (const AxisImage& image : at_home) {
        const double image_low = (image.mirrored ? -own.high[axis] : own.low[axis]) + image.shift;
        const double image_high = (image.mirrored ? -own.low[axis] : own.high[axis]) + image.shift;
        // One more on either side, for rounding; the caller drops those that are too far.
        const int first = static_cast<int>(std::floor((other.low[axis] - reach - image_high) / period));
        const int last = static_cast<int>(std::ceil((other.high[axis] + reach - image_low) / period));
        for (int k = first; k <= last; ++k) images.push_back({image.shift + k * period, image.mirrored});
    }
    return images;
}

}  // namespace

HaloTargets::HaloTargets(const Domain& domain, const Ranks& ranks, const ParticleSpace& space, double reach)
    : dimension_(space.dimension) {
    const double far = reach * (1 + margin);
    squared_reach_ = far * far;
    const Box& own = domain.box(ranks.rank());
    for (int axis = 0; axis < 3; ++axis) {
        inner_low_[axis] = own.low[axis] + far;
        inner_high_[axis] = own.high[axis] - far;
    }
    if (is_empty(own, dimension_)) return;
    for (int rank = 0; rank < ranks.size(); ++rank) {
        const Box& other = domain.box(rank);
        if (is_empty(other, dimension_)) continue;
        std::array<std::vector<AxisImage>, 3> images;
        for (int axis = 0; axis < 3; ++axis)
            images[axis] = axis < dimension_ ? images_between(own, other, space, axis, far) : std::vector<AxisImage>(1);
        for (const AxisImage& z : images[2])
            for (const AxisImage& y : images[1])
                for (const AxisImage& x : images[0]) {
                    const std::array<AxisImage, 3> image{x, y, z};
                    HaloTarget target{rank, {}, other};
                    bool is_home = rank == ranks.rank();
                    double squared = 0;
                    for (int axis = 0; axis < dimension_; ++axis) {
                        target.image.shift[axis] = image[axis].shift;
                        target.image.mirrored[axis] = image[axis].mirrored;
                        is_home = is_home && image[axis].shift == 0 && !image[axis].mirrored;
                        const double along =
                            apart(own.low[axis], own.high[axis], image[axis], other.low[axis], other.high[axis]);
                        squared += along * along;
                    }
                    if (!is_home && squared <= squared_reach_) list_.push_back(target);
                }
    }
}

}  // namespace dmp::solver
