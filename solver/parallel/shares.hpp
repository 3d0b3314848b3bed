// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace dmp::solver {

/// Calls work(thread) for each thread index below `threads`. A single thread is called directly: an OpenMP region of
/// one thread makes a system call, which is slow compared with the work on few particles.
template <class Work>
void on_each_thread(int threads, const Work& work) {
    if (threads == 1) {
        work(0);
        return;
    }
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int thread = 0; thread < threads; ++thread) work(thread);
}

/// Calls work(first, end) for each thread's share of 0 to count.
template <class Work>
void in_shares(std::size_t count, int threads, const Work& work) {
    const auto all = static_cast<std::size_t>(threads);
    on_each_thread(threads, [&](int thread) {
        const auto own = static_cast<std::size_t>(thread);
        work(count * own / all, count * (own + 1) / all);
    });
}

}  // namespace dmp::solver
