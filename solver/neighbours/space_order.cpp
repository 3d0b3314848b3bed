// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/space_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "solver/neighbours/sort_by_cell.hpp"
#include "solver/parallel/each_of.hpp"
#include "solver/parallel/low_and_high.hpp"

namespace dmp::solver {

namespace {

constexpr int cells_a_column = 64;

/// The cells for sorting a group: two spacings wide; x fastest inside a column, then y and z; one column after the
/// other.
class Cells {
  public:
    /// Starts half a spacing below the lowest particle, so that each cell contains two rows of a lattice.
    Cells(const ParticleGroup& group, double spacing, int threads) : inverse_size_(0.5 / spacing) {
        std::array<double, 3> cells{1, 1, 1};
        for (int axis = 0; axis < group.dimension(); ++axis) {
            const double* x = group.data(Field::position, axis);
            const auto [low, high] = low_and_high(static_cast<std::ptrdiff_t>(group.owned()), threads,
                                                  [x](std::ptrdiff_t i) { return x[i]; });
            low_[axis] = low - spacing / 2;
            cells[axis] = std::floor((high - low_[axis]) * inverse_size_) + 1;
        }
        const double whole_columns = std::ceil(cells[0] / cells_a_column) * cells_a_column;
        sparse_ = !(whole_columns * cells[1] * cells[2] <= 8.0 * static_cast<double>(group.owned()) + 4096);
        for (int axis = 0; axis < 3; ++axis)
            count_[axis] = static_cast<std::int64_t>(sparse_ ? std::min(cells[axis], most_of_sparse) : cells[axis]);
        columns_ = (count_[0] + cells_a_column - 1) / cells_a_column;
    }

    /// True if there are too many cells for a counting sort: some particle is far from all others.
    [[nodiscard]] bool sparse() const { return sparse_; }
    [[nodiscard]] std::int64_t size() const { return columns_ * cells_a_column * count_[1] * count_[2]; }

    [[nodiscard]] std::int64_t of(const std::array<const double*, 3>& x, std::size_t i, int dimension) const {
        std::array<std::int64_t, 3> cell{};
        for (int axis = 0; axis < dimension; ++axis)
            cell[axis] = static_cast<std::int64_t>(
                std::min((x[axis][i] - low_[axis]) * inverse_size_, static_cast<double>(count_[axis] - 1)));
        const std::int64_t column = cell[0] / cells_a_column;
        return strip(column, cell[1], cell[2]) * cells_a_column + cell[0] % cells_a_column;
    }
    /// The strip that contains a cell.
    static std::int64_t strip_of(std::int64_t cell) { return cell / cells_a_column; }

  private:
    [[nodiscard]] std::int64_t strip(std::int64_t column, std::int64_t y, std::int64_t z) const {
        return (column * count_[2] + z) * count_[1] + y;
    }

    /// By axis, of cells that are numbered where there are too many: more would not fit into a number.
    static constexpr double most_of_sparse = 1 << 20;

    double inverse_size_;
    bool sparse_ = false;
    std::array<double, 3> low_{};
    std::array<std::int64_t, 3> count_{1, 1, 1};
    std::int64_t columns_ = 1;
};

/// Particle numbers sorted by body and cell. Uses a counting sort if there are few enough cells, as is usual unless a
/// particle has flown away.
Uninitialized<std::int32_t> order_by_cell(const ParticleGroup& group, const Cells& cells,
                                          const Uninitialized<std::int64_t>& cell, int threads) {
    Uninitialized<std::int32_t> order(group.owned());
    if (group.kind() == PartKind::elastic || cells.sparse()) {
        std::iota(order.begin(), order.end(), 0);
        const auto tags = group.tags();
        std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
            return std::pair(tags[a].body, cell[a]) < std::pair(tags[b].body, cell[b]);
        });
        return order;
    }
    return sort_by_cell(std::span<const std::int64_t>(cell), static_cast<std::size_t>(cells.size()), threads).order;
}

/// Criteria for cutting particles into clusters.
struct Strips {
    const double* x;
    const Uninitialized<std::int64_t>& cell;
    std::span<const ParticleTag> tags;

    [[nodiscard]] bool are_one(std::int32_t a, std::int32_t b) const {
        return Cells::strip_of(cell[a]) == Cells::strip_of(cell[b]) && tags[a].body == tags[b].body;
    }
};

/// Sorts order[begin, end), which consists of whole strips, along x within each strip, and cuts it into clusters.
std::vector<Cluster> cut_strips(Uninitialized<std::int32_t>& order, std::size_t begin, std::size_t end_of_all,
                                const Strips& strips, double longest) {
    std::vector<Cluster> clusters;
    clusters.reserve((end_of_all - begin) / cluster_size + (end_of_all - begin) / 64 + 1);
    const double* x = strips.x;
    while (begin < end_of_all) {
        std::size_t end = begin + 1;
        while (end < end_of_all && strips.are_one(order[begin], order[end])) ++end;
        // Cells are already in order along x: few particles move.
        for (std::size_t k = begin + 1; k < end; ++k) {
            const std::int32_t moving = order[k];
            std::size_t position = k;
            for (; position > begin && x[order[position - 1]] > x[moving]; --position)
                order[position] = order[position - 1];
            order[position] = moving;
        }
        while (begin < end) {
            Cluster cluster{static_cast<std::int32_t>(begin), 0};
            const double start = x[order[begin]];
            while (begin < end && cluster.count < cluster_size && x[order[begin]] - start < longest) {
                ++cluster.count;
                ++begin;
            }
            clusters.push_back(cluster);
        }
    }
    return clusters;
}

}  // namespace

std::vector<Cluster> sort_in_space(ParticleGroup& group, double spacing, int threads) {
    const std::size_t owned = group.owned();
    if (owned == 0) {
        group.reorder({});
        return {};
    }
    const Cells cells(group, spacing, threads);
    std::array<const double*, 3> x{};
    for (int axis = 0; axis < group.dimension(); ++axis) x[axis] = group.data(Field::position, axis);
    Uninitialized<std::int64_t> cell(owned);
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(owned); ++i)
        cell[i] = cells.of(x, static_cast<std::size_t>(i), group.dimension());

    Uninitialized<std::int32_t> order = order_by_cell(group, cells, cell, threads);
    const Strips strips{x[0], cell, group.tags()};
    // One run of strips per thread, each cut separately; then the clusters are joined.
    std::vector<std::size_t> begin{0};
    for (int t = 1; t < threads; ++t) {
        std::size_t k = std::max(begin.back(), owned * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads));
        while (k > 0 && k < owned && strips.are_one(order[k - 1], order[k])) ++k;
        begin.push_back(k);
    }
    begin.push_back(owned);
    std::vector<std::vector<Cluster>> parts(static_cast<std::size_t>(threads));
    each_of(threads, threads, [&](std::ptrdiff_t t) {
        parts[t] = cut_strips(order, begin[t], begin[t + 1], strips, spacing * cluster_size);
    });
    std::vector<Cluster> clusters = std::move(parts[0]);
    for (int t = 1; t < threads; ++t) clusters.insert(clusters.end(), parts[t].begin(), parts[t].end());
    group.reorder(order, threads);
    return clusters;
}

}  // namespace dmp::solver
