// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "solver/parallel/exact_sum.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// Calls visit(i, sums) for each owned particle and adds up the terms that it adds to `sums`, without rounding.
template <std::size_t Count, class Visit>
std::array<ExactSum, Count> sums_over(const ParticleGroup& group, int threads, const Visit& visit) {
    const auto count = static_cast<std::ptrdiff_t>(group.owned());
    std::array<ExactSum, Count> all;
#pragma omp parallel num_threads(threads)
    {
        std::array<ExactSum, Count> own;
#pragma omp for schedule(static) nowait
        for (std::ptrdiff_t i = 0; i < count; ++i) visit(i, own);
#pragma omp critical(dmp_sums_over)
        for (std::size_t k = 0; k < Count; ++k) all[k].add(own[k]);
    }
    return all;
}

/// The same for terms that are multiples of one quantum: 32 of them add up exactly in doubles (ReproducibleSum),
/// which is faster than adding them one by one.
template <std::size_t Count, class Visit>
std::array<ExactSum, Count> sums_of_multiples(const ParticleGroup& group, int threads, const Visit& visit) {
    constexpr std::ptrdiff_t at_a_time = 32;
    const auto count = static_cast<std::ptrdiff_t>(group.owned());
    std::array<ExactSum, Count> all;
#pragma omp parallel num_threads(threads)
    {
        std::array<ExactSum, Count> own;
#pragma omp for schedule(static) nowait
        for (std::ptrdiff_t begin = 0; begin < count; begin += at_a_time) {
            std::array<double, Count> some{};
            for (std::ptrdiff_t i = begin; i < std::min(begin + at_a_time, count); ++i) visit(i, some);
            for (std::size_t k = 0; k < Count; ++k) own[k].add(some[k]);
        }
#pragma omp critical(dmp_sums_over)
        for (std::size_t k = 0; k < Count; ++k) all[k].add(own[k]);
    }
    return all;
}

/// Raises tiny values to the smallest for which a ReproducibleSum can be made.
inline double at_least_something(double value) { return std::max(value, 1e-280); }

}  // namespace dmp::solver
