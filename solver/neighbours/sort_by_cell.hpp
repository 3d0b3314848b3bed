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

/// Particle numbers by cell; within a cell they keep their order.
struct SortedByCell {
    Uninitialized<std::int32_t> order;
    std::vector<std::int32_t> start;  ///< first element of each cell in `order`, and its size at the end
};

/// @param cell by particle, from 0 to `cells` - 1; another value is a std::logic_error
/// A counting sort. Each thread reads all particles; it counts those in its own range of cells and places those in
/// another range, chosen such that all threads place about the same number. No two threads share a counter.
template <class Cell>
SortedByCell sort_by_cell(std::span<const Cell> cell, std::size_t cells, int threads) {
    // Every thread reads all particles: more threads than this would wait for memory.
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
    std::vector<std::int32_t> next(sorted.start.begin(), sorted.start.end() - 1);  // next free position, by cell
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
