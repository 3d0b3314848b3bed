// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_skins.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

namespace {

/// What a sphere that is at rest now is taken to move at, as it will be hit [mean speeds].
constexpr double speed_at_rest = 1;

double speed_in(const std::array<double, 3>& frame, const SphereMotion& sphere) {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double v = sphere.velocity.c[axis] - frame[axis];
        square += v * v;
    }
    return std::sqrt(square);
}

}  // namespace

void SphereSkins::make(const SphereRows& rows, const std::array<double, 3>& frame, double mean, double most,
                       const Ranks& ranks, int threads) {
    make(rows, frame, mean, ranks, threads, [most](std::ptrdiff_t) { return most; });
}

void SphereSkins::make_within(double share, const SphereSkins& other, const SphereRows& rows,
                              const std::array<double, 3>& frame, double mean, const Ranks& ranks, int threads) {
    make(rows, frame, mean, ranks, threads, [&](std::ptrdiff_t i) { return share * other.skin_[i]; });
}

/// Ranks agree on the mean speed, and so on skins.
template <class Limit>
void SphereSkins::make(const SphereRows& rows, const std::array<double, 3>& frame, double mean, const Ranks& ranks,
                       int threads, const Limit& limit) {
    const auto total = static_cast<std::ptrdiff_t>(rows.total()), owned = static_cast<std::ptrdiff_t>(rows.owned());
    const auto motion = rows.motion();
    skin_.resize(rows.total());
    inverse_square_.resize(rows.total());
    double speeds = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(+ : speeds)
    for (std::ptrdiff_t i = 0; i < total; ++i) {
        const double speed = speed_in(frame, motion[i]);
        skin_[i] = static_cast<float>(speed);
        speeds += i < owned && std::isfinite(speed) ? speed : 0;
    }
    std::array<ExactSum, 2> sums;
    sums[0].add(speeds);
    sums[1].add(static_cast<double>(owned));
    ranks.sum(sums);
    const double mean_speed = sums[0].value() / std::max(1.0, sums[1].value());
    const double at_rest = speed_at_rest * mean_speed, scale = mean / ((1 + speed_at_rest) * mean_speed);
    double least = mean, largest = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(min : least) reduction(max : largest)
    for (std::ptrdiff_t i = 0; i < total; ++i) {
        const double asked = mean_speed > 0 ? scale * (skin_[i] + at_rest) : mean, most = limit(i);
        const double skin = asked < most ? asked : most;
        skin_[i] = static_cast<float>(skin);
        inverse_square_[i] = 1 / (skin_[i] * skin_[i]);
        least = std::min(least, skin);
        largest = std::max(largest, skin);
    }
    mean_ = mean;
    least_ = least;
    largest_ = largest;
}

}  // namespace dmp::solver
