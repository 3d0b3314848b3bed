// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include "base/uninitialized.hpp"
#include "solver/parallel/select.hpp"

namespace dmp::solver {

/// The numbers of particles, those of the first cell first, those of one cell in their own order.
struct SortedByCell {
    Uninitialized<std::int32_t> order;
    std::vector<std::int32_t> start;  ///< where each cell begins in it; one more at the end
};

/// @param cell by particle, from 0 to `cells` - 1; another is an std::logic_error
/// A counting sort. Each thread reads all, and counts what lies in cells of its own, then places what lies in others
/// of its own, such that all place alike: no counter is of two threads.
template <class Cell>
SortedByCell sort_by_cell(std::span<const Cell> cell, std::size_t cells, int threads) {
    // Each reads all: more of them than this wait for memory.
    threads = cell.size() < worth_threads ? 1 : std::min(threads, 8);
    SortedByCell sorted;
    sorted.start.assign(cells + 1, 0);
    sorted.order.resize(cell.size());
    std::int32_t* start = sorted.start.data();
    const auto share = [threads](std::size_t of, int t) {
        return of * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads);
    };
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int t = 0; t < threads; ++t) {
        const std::size_t first = share(cells, t), count = share(cells, t + 1) - first;
        for (const Cell c : cell)
            if (const std::size_t own = static_cast<std::size_t>(c) - first; own < count) ++start[c + 1];
    }
    std::partial_sum(sorted.start.begin(), sorted.start.end(), sorted.start.begin());
    if (static_cast<std::size_t>(sorted.start.back()) != cell.size())
        throw std::logic_error("sort_by_cell: a particle is in no cell");
    std::vector<std::int32_t> next(sorted.start.begin(), sorted.start.end() - 1);  // free place, by cell
    const auto first_cell = [&](int t) {
        const auto begin = sorted.start.begin(), end = sorted.start.end() - 1;
        return t == threads
                   ? cells
                   : static_cast<std::size_t>(
                         std::lower_bound(begin, end, static_cast<std::int32_t>(share(cell.size(), t))) - begin);
    };
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int t = 0; t < threads; ++t) {
        const std::size_t first = t == 0 ? 0 : first_cell(t), count = first_cell(t + 1) - first;
        for (std::size_t i = 0; i < cell.size(); ++i)
            if (static_cast<std::size_t>(cell[i]) - first < count)
                sorted.order[next[static_cast<std::size_t>(cell[i])]++] = static_cast<std::int32_t>(i);
    }
    return sorted;
}

}  // namespace dmp::solver
