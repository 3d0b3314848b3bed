// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/displacement_tracker.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "solver/parallel/largest_square.hpp"

namespace dmp::solver {

namespace {

/// `stride` is a compile-time constant for contiguous coordinates, so that the compiler can vectorise.
template <int D, class Stride, class Weight>
double largest_square(const Positions& now, int threads, const std::array<std::vector<float>, 3>& from_origin,
                      const std::array<double, 3>& origin, Stride stride, const Weight& weight) {
    const auto count = static_cast<std::ptrdiff_t>(from_origin[0].size());
    double found = 0;
#pragma omp parallel num_threads(threads) reduction(max : found)
    {
        LargestSquare largest;
#pragma omp for schedule(static) nowait
        for (std::ptrdiff_t begin = 0; begin < count; begin += LargestSquare::at_a_time) {
            const std::ptrdiff_t some = std::min(LargestSquare::at_a_time, count - begin);
            LargestSquare::Squares square{};
            for (int axis = 0; axis < D; ++axis) {
                const float* then = from_origin[axis].data() + begin;
                const double* x = now.first[axis] + begin * stride;
                const double start = origin[axis] + now.common[axis];
                for (std::ptrdiff_t k = 0; k < some; ++k) {
                    const double gone = x[k * stride] - start - then[k];
                    square[k] += gone * gone;
                }
            }
            for (std::ptrdiff_t k = 0; k < some; ++k) square[k] *= weight(begin + k);
            largest.update(square);
        }
        found = largest.value();
    }
    return found;
}

template <class Weight>
double farthest(const Positions& now, int threads, const std::array<std::vector<float>, 3>& from_origin,
                const std::array<double, 3>& origin, const Weight& weight) {
    if (now.count != from_origin[0].size())
        throw std::logic_error("positions of " + std::to_string(now.count) +
                               " particles given, but reference positions of " + std::to_string(from_origin[0].size()) +
                               " stored");
    const auto of = [&]<int D>() {
        return now.stride == 1 ? largest_square<D>(now, threads, from_origin, origin,
                                                   std::integral_constant<std::ptrdiff_t, 1>{}, weight)
                               : largest_square<D>(now, threads, from_origin, origin,
                                                   static_cast<std::ptrdiff_t>(now.stride), weight);
    };
    return std::sqrt(now.dimension == 3 ? of.template operator()<3>() : of.template operator()<2>());
}

}  // namespace

void ReferencePositions::take(const Positions& positions, int threads) {
    dimension_ = positions.dimension;
    double largest_of_all = 0;
    for (int axis = 0; axis < dimension_; ++axis) {
        std::vector<float>& then = from_origin_[axis];
        then.resize(positions.count);
        const double* x = positions.first[axis];
        const double origin = origin_[axis] = positions.count > 0 ? *x : 0;
        float largest = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(max : largest)
        for (std::size_t i = 0; i < positions.count; ++i) {
            then[i] = static_cast<float>(x[i * positions.stride] - origin);
            largest = std::max(largest, std::abs(then[i]));
        }
        largest_of_all = std::max(largest_of_all, static_cast<double>(largest));
    }
    // Half a unit in the last place along each axis, plus the rounding of doubles.
    inexact_ = 0.51 * std::sqrt(dimension_) * largest_of_all * std::numeric_limits<float>::epsilon();
}

double ReferencePositions::farthest_gone(const Positions& now, int threads) const {
    return farthest(now, threads, from_origin_, origin_, [](std::ptrdiff_t) { return 1.0; }) + inexact_;
}

double ReferencePositions::farthest_gone(const Positions& now, int threads, std::span<const float> inverse_squares,
                                         double shortest) const {
    const auto weight = [inverse_squares](std::ptrdiff_t i) { return inverse_squares[static_cast<std::size_t>(i)]; };
    return farthest(now, threads, from_origin_, origin_, weight) + inexact_ / shortest;
}

std::size_t ReferencePositions::bytes() const {
    return static_cast<std::size_t>(dimension_) * from_origin_[0].capacity() * sizeof(float);
}

}  // namespace dmp::solver
