// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace dmp::solver {

/// With fewer elements than this, threads cost more than they save.
constexpr std::size_t worth_threads = 20000;

/// The indices below `count` for which test(index) is true, in order.
template <class Test>
std::vector<std::int32_t> select(std::size_t count, int threads, const Test& test) {
    constexpr std::size_t block = 4096;
    const std::size_t blocks = (count + block - 1) / block;
    std::vector<std::vector<std::int32_t>> found(blocks);
#pragma omp parallel for num_threads(threads) schedule(static) if (count >= worth_threads)
    for (std::size_t k = 0; k < blocks; ++k) {
        std::array<std::int32_t, block> chosen;
        std::size_t size = 0;
        for (std::size_t i = k * block; i < std::min((k + 1) * block, count); ++i) {
            chosen[size] = static_cast<std::int32_t>(i);
            size += test(i) ? 1 : 0;  // no branch: it would be mispredicted
        }
        found[k].assign(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(size));
    }
    std::vector<std::int32_t> all;
    for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace dmp::solver
