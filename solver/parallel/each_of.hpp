// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <exception>

namespace dmp::solver {

/// Calls task(k) for every k below `count`, distributed round-robin over threads. No exception may leave a parallel
/// loop: the one with the lowest k (memory may run out) is rethrown when all calls have ended.
template <class Task>
void each_of(std::ptrdiff_t count, int threads, const Task& task) {
    std::exception_ptr error;
    std::ptrdiff_t failed = count;
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        try {
            task(k);
        } catch (...) {
#pragma omp critical(dmp_each_of)
            if (k < failed) {
                failed = k;
                error = std::current_exception();
            }
        }
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace dmp::solver
