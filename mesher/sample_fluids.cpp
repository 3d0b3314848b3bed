// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/sample_fluids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <sstream>
#include <utility>
#include <vector>

#include "base/random_number.hpp"
#include "mesher/close_pairs.hpp"
#include "mesher/uses.hpp"
#include "models/sph/kernels.hpp"

namespace dmp::mesher {

namespace {

constexpr int candidates_per_particle = 4;
/// So many particles, about, are left in each block of the room by its share of the candidates: what walls at different
/// distances push about would else stay as a difference in density over tens of spacings.
constexpr double particles_per_block = 200;

/// Half the distance of neighbours in the densest packing of places that stand for so much room each.
double densest(int dimension, double cell_volume) {
    return dimension == 3 ? std::cbrt(cell_volume / (4 * std::sqrt(2.0)))
                          : std::sqrt(cell_volume / (2 * std::sqrt(3.0)));
}

/// Cubes with the volume that a particle stands for, all over the box; those next to particles of the fluid are marked.
class Cells {
  public:
    Cells(const ParticleSet& set, double cell_volume)
        : low_(set.box.low), side_(std::pow(cell_volume, 1.0 / set.dimension)), dimension_(set.dimension) {
        std::size_t cells = 1;
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
            // One more: a particle on the far side of the box, by rounding.
            counts_[axis] =
                static_cast<std::ptrdiff_t>(std::floor(set.box.extent()[static_cast<Eigen::Index>(axis)] / side_)) + 2;
            cells *= static_cast<std::size_t>(counts_[axis]);
        }
        marked_.resize(cells);
        for (std::size_t i = 0; i < set.size(); ++i)
            if (set.kind(i) == PartKind::fluid) mark_around(set.position[i]);
    }

    /// Calls visit(number of the cell, its low corner) for what is marked, in order.
    template <class Visit>
    void for_each_marked(const Visit& visit) const {
        for (std::size_t cell = 0; cell < marked_.size(); ++cell) {
            if (!marked_[cell]) continue;
            auto rest = static_cast<std::ptrdiff_t>(cell);
            Vec corner = low_;
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
                corner[static_cast<Eigen::Index>(axis)] += static_cast<double>(rest % counts_[axis]) * side_;
                rest /= counts_[axis];
            }
            visit(cell, corner);
        }
    }
    [[nodiscard]] double side() const { return side_; }

  private:
    void mark_around(const Vec& position) {
        std::array<std::ptrdiff_t, 3> first{}, last{};
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
            const auto a = static_cast<Eigen::Index>(axis);
            const auto at = static_cast<std::ptrdiff_t>(std::floor((position[a] - low_[a]) / side_));
            first[axis] = std::clamp<std::ptrdiff_t>(at - 1, 0, counts_[axis] - 1);
            last[axis] = std::clamp<std::ptrdiff_t>(at + 1, 0, counts_[axis] - 1);
        }
        for (auto z = first[2]; z <= last[2]; ++z)
            for (auto y = first[1]; y <= last[1]; ++y)
                for (auto x = first[0]; x <= last[0]; ++x)
                    marked_[static_cast<std::size_t>((z * counts_[1] + y) * counts_[0] + x)] = true;
    }

    Vec low_;
    double side_;
    int dimension_;
    std::array<std::ptrdiff_t, 3> counts_{1, 1, 1};
    std::vector<bool> marked_;
};

/// Places at random in the fluid's room, their parts, and what stands near them and stays: part -1.
ParticleSet candidates_of(const ParticleSet& set, double cell_volume, std::uint64_t seed, const FluidPartAt& part_at,
                          int threads) {
    ParticleSet all;
    static_cast<ParticleSpace&>(all) = set;
    const Cells cells(set, cell_volume);
    cells.for_each_marked([&](std::size_t cell, const Vec& corner) {
        for (std::uint64_t k = 0; k < candidates_per_particle; ++k) {
            Vec position = corner;
            bool in_box = true;
            for (int axis = 0; axis < set.dimension; ++axis) {
                position[axis] += cells.side() * random_number({seed, cell, k, static_cast<std::uint64_t>(axis)});
                in_box = in_box && position[axis] < set.box.high[axis];
            }
            if (in_box) all.position.push_back(position);
        }
    });
    all.part.resize(all.size());
    const auto count = static_cast<std::ptrdiff_t>(all.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        all.part[i] = part_at(all.position[i]);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all.part[i] < 0) continue;
        all.position[kept] = all.position[i];
        all.part[kept++] = all.part[i];
    }
    all.position.resize(kept);
    all.part.resize(kept);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) != PartKind::fluid) all.position.push_back(set.position[i]);
    all.part.resize(all.size(), -1);
    return all;
}

/// How many are to be left where.
struct Quotas {
    std::vector<std::size_t> quota_of;       ///< by candidate
    std::vector<std::size_t> offered, left;  ///< by quota: candidates, and how many of them are to be left
};

/// Shares out what is wanted of each part (`wanted`) over blocks of the room, by the candidates there.
Quotas share_out(const ParticleSet& all, const std::vector<std::size_t>& wanted, double cell_volume) {
    const double side = std::pow(particles_per_block * cell_volume, 1.0 / all.dimension);
    using Block = std::array<long, 4>;  // part, and place along each axis
    const auto block_of = [&](std::size_t i) {
        Block block{all.part[i], 0, 0, 0};
        for (int axis = 0; axis < all.dimension; ++axis)
            block[static_cast<std::size_t>(axis) + 1] = std::lround((all.position[i][axis] - all.box.low[axis]) / side);
        return block;
    };
    std::map<Block, std::size_t> number;
    Quotas quotas;
    quotas.quota_of.resize(all.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all.part[i] < 0) continue;
        const std::size_t quota = number.try_emplace(block_of(i), number.size()).first->second;
        quotas.quota_of[i] = quota;
        quotas.offered.resize(number.size(), 0);
        ++quotas.offered[quota];
    }
    // By the sums so far, so that no part loses any to rounding.
    std::vector<std::size_t> of_part(wanted.size(), 0), seen(wanted.size(), 0);
    for (const auto& [block, quota] : number) of_part[static_cast<std::size_t>(block[0])] += quotas.offered[quota];
    quotas.left.resize(number.size());
    for (const auto& [block, quota] : number) {
        const auto part = static_cast<std::size_t>(block[0]);
        const auto so_far = [&] { return wanted[part] * seen[part] / of_part[part]; };
        const std::size_t before = so_far();
        seen[part] += quotas.offered[quota];
        quotas.left[quota] = so_far() - before;
    }
    return quotas;
}

/// Eliminates until no more are left than the quotas say. By candidate: whether it is left.
template <int D>
std::vector<std::uint8_t> eliminate(const ParticleSet& all, const Quotas& quotas, double reach, int threads) {
    std::vector<std::uint8_t> stays(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) stays[i] = all.part[i] < 0 ? 1 : 0;
    std::vector<std::size_t> left = quotas.offered;
    ClosePairs pairs;
    pairs.find(all, stays, reach, threads);
    const auto weight = [&](double square_of_distance) {
        const double gap = 1 - std::sqrt(square_of_distance) / reach;
        return square(square(square(gap)));
    };
    std::vector<double> crowding(all.size(), 0);
    const auto count = static_cast<std::ptrdiff_t>(all.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        pairs.for_each_near<D>(i, [&](std::size_t, const auto&, double square) { crowding[i] += weight(square); });
    }
    // An entry of the queue may be out of date: places only get less crowded, so the one that is due comes no later.
    std::priority_queue<std::pair<double, std::size_t>> queue;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (stays[i] == 0) queue.emplace(crowding[i], i);
    while (!queue.empty()) {
        const auto [noted, i] = queue.top();
        queue.pop();
        const std::size_t quota = quotas.quota_of[i];
        if (left[quota] <= quotas.left[quota]) {
            stays[i] = 1;
            continue;
        }
        if (crowding[i] < noted) {
            queue.emplace(crowding[i], i);
            continue;
        }
        --left[quota];
        pairs.for_each_near<D>(i, [&](std::size_t j, const auto&, double square) { crowding[j] -= weight(square); });
    }
    return stays;
}

}  // namespace

std::string sample_fluids(ParticleSet& set, double cell_volume, std::uint64_t seed, const FluidPartAt& part_at,
                          int threads) {
    ParticleSet all = candidates_of(set, cell_volume, seed, part_at, threads);
    std::vector<std::size_t> wanted(set.parts.size(), 0), offered(set.parts.size(), 0);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::fluid) ++wanted[static_cast<std::size_t>(set.part[i])];
    for (const int part : all.part)
        if (part >= 0) ++offered[static_cast<std::size_t>(part)];
    // Where the room of a part is so small that chance left it too few, its lattice points are to choose from, too.
    for (std::size_t i = 0; i < set.size(); ++i) {
        const auto part = static_cast<std::size_t>(set.part[i]);
        if (set.kind(i) != PartKind::fluid || offered[part] >= wanted[part]) continue;
        all.position.push_back(set.position[i]);
        all.part.push_back(set.part[i]);
    }
    const double reach = 2 * densest(set.dimension, cell_volume);
    const Quotas quotas = share_out(all, wanted, cell_volume);
    const auto stays =
        set.dimension == 3 ? eliminate<3>(all, quotas, reach, threads) : eliminate<2>(all, quotas, reach, threads);
    std::vector<std::vector<Vec>> positions(set.parts.size());  // by part
    std::size_t candidates = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all.part[i] < 0) continue;
        ++candidates;
        if (stays[i] != 0) positions[static_cast<std::size_t>(all.part[i])].push_back(all.position[i]);
    }
    std::vector<std::size_t> next(set.parts.size(), 0);
    std::size_t placed = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        const auto part = static_cast<std::size_t>(set.part[i]);
        set.position[i] = positions[part].at(next[part]++);
        ++placed;
    }
    std::ostringstream note;
    note << "sampled: the fluid's " << placed << " particles are the least crowded of " << candidates
         << " places at random, seed " << seed;
    return note.str();
}

}  // namespace dmp::mesher
