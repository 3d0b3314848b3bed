// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/close_pairs.hpp"

#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::mesher {

/// Images across both ends of an axis, of particles and of the images there are already.
void ClosePairs::add_images(const ParticleSet& set, int axis, double reach) {
    const auto at = static_cast<std::size_t>(axis);
    const double low = set.box.low[axis], high = set.box.high[axis];
    const std::size_t count = points_[0].size();
    const auto add = [&](std::size_t k, double sign, double offset) {
        Image image{static_cast<std::int32_t>(k), {1, 1, 1}, {0, 0, 0}};
        if (k >= owned_) image = images_[k - owned_];
        image.sign.at(at) *= sign;
        image.offset.at(at) = sign * image.offset.at(at) + offset;
        images_.push_back(image);
        for (std::size_t a = 0; a < static_cast<std::size_t>(set.dimension); ++a)
            points_[a].push_back(a == at ? sign * points_[a][k] + offset : points_[a][k]);
    };
    for (std::size_t k = 0; k < count; ++k) {
        const double x = points_[at][k];
        if (set.periodic.at(at)) {
            if (x - low < reach) add(k, 1, high - low);
            if (high - x < reach) add(k, 1, low - high);
        }
        if (set.mirrored.at(at)[0] && x - low < reach) add(k, -1, 2 * low);
        if (set.mirrored.at(at)[1] && high - x < reach) add(k, -1, 2 * high);
    }
}

void ClosePairs::find(const ParticleSet& set, const std::vector<std::uint8_t>& left_out, double reach, int threads) {
    owned_ = set.size();
    images_.clear();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        points_[axis].clear();
        if (axis >= static_cast<std::size_t>(set.dimension)) continue;
        points_[axis].reserve(owned_);
        for (const Vec& position : set.position) points_[axis].push_back(position[static_cast<Eigen::Index>(axis)]);
    }
    for (int axis = 0; axis < set.dimension; ++axis) add_images(set, axis, reach);
    const CellGrid grid(points_, points_[0].size(), set.dimension, reach);

    const auto count = static_cast<std::ptrdiff_t>(owned_);
    const auto near = [&](std::size_t i, const auto& visit) {
        std::array<double, 3> here{};
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(set.dimension); ++axis)
            here[axis] = points_[axis][i];
        grid.for_each_near(here, reach, [&](int j) {
            double square = 0;
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(set.dimension); ++axis) {
                const double d = here[axis] - points_[axis][static_cast<std::size_t>(j)];
                square += d * d;
            }
            if (square < reach * reach && static_cast<std::size_t>(j) != i) visit(j);
        });
    };
    // Counted first, then listed: no more memory than the list itself.
    first_.assign(owned_ + 1, 0);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (left_out[i] == 0) near(i, [&](int) { ++first_[i + 1]; });
    }
    for (std::size_t i = 0; i < owned_; ++i) first_[i + 1] += first_[i];
    listed_.resize(first_[owned_]);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        std::size_t next = first_[i];
        if (left_out[i] == 0) near(i, [&](int j) { listed_[next++] = j; });
    }
}

void ClosePairs::follow(const ParticleSet& set) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(set.dimension); ++axis) {
        for (std::size_t i = 0; i < owned_; ++i) points_[axis][i] = set.position[i][static_cast<Eigen::Index>(axis)];
        for (std::size_t k = 0; k < images_.size(); ++k) {
            const Image& image = images_[k];
            points_[axis][owned_ + k] =
                image.sign.at(axis) * points_[axis][static_cast<std::size_t>(image.source)] + image.offset.at(axis);
        }
    }
}

std::size_t ClosePairs::bytes() const {
    std::size_t bytes = images_.capacity() * sizeof(Image) + first_.capacity() * sizeof(std::size_t) +
                        listed_.capacity() * sizeof(std::int32_t);
    for (const auto& axis : points_) bytes += axis.capacity() * sizeof(double);
    return bytes;
}

}  // namespace dmp::mesher
