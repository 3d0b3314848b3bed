// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/space_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dmp {

namespace {

constexpr int cells_a_column = 64;

/// The cells that a group is sorted by: two spacings wide, x fastest inside a column, then y and z; columns side by
/// side.
class Cells {
  public:
    /// Half a spacing of room below, so that the rows of a lattice fall into the cells two by two.
    Cells(const ParticleGroup& group, double spacing) : inverse_size_(0.5 / spacing) {
        for (int axis = 0; axis < group.dimension(); ++axis) {
            const double* x = group.data(Field::position, axis);
            const auto [low, high] = std::minmax_element(x, x + group.owned());
            low_[axis] = *low - spacing / 2;
            count_[axis] = static_cast<std::int64_t>((*high - low_[axis]) * inverse_size_) + 1;
        }
        columns_ = (count_[0] + cells_a_column - 1) / cells_a_column;
    }

    /// Too many to count particles by: some particle is far from all others.
    [[nodiscard]] bool sparse(std::size_t particles) const {
        return static_cast<double>(columns_) * cells_a_column * static_cast<double>(count_[1]) *
                   static_cast<double>(count_[2]) >
               8.0 * static_cast<double>(particles) + 4096;
    }
    [[nodiscard]] std::int64_t size() const { return columns_ * cells_a_column * count_[1] * count_[2]; }

    [[nodiscard]] std::int64_t of(const std::array<const double*, 3>& x, std::size_t i, int dimension) const {
        std::array<std::int64_t, 3> cell{};
        for (int axis = 0; axis < dimension; ++axis)
            cell[axis] = static_cast<std::int64_t>((x[axis][i] - low_[axis]) * inverse_size_);
        const std::int64_t column = cell[0] / cells_a_column;
        return strip(column, cell[1], cell[2]) * cells_a_column + cell[0] % cells_a_column;
    }
    /// The strip that a cell belongs to.
    static std::int64_t strip_of(std::int64_t cell) { return cell / cells_a_column; }

  private:
    [[nodiscard]] std::int64_t strip(std::int64_t column, std::int64_t y, std::int64_t z) const {
        return (column * count_[2] + z) * count_[1] + y;
    }

    double inverse_size_;
    std::array<double, 3> low_{};
    std::array<std::int64_t, 3> count_{1, 1, 1};
    std::int64_t columns_ = 1;
};

/// Particle numbers by body and cell. A counting sort where cells are few enough, which they are unless a particle flew
/// away.
std::vector<std::int32_t> order_by_cell(const ParticleGroup& group, const Cells& cells,
                                        const std::vector<std::int64_t>& cell) {
    std::vector<std::int32_t> order(group.owned());
    if (group.kind() == ParticleKind::springs || cells.sparse(group.owned())) {
        std::iota(order.begin(), order.end(), 0);
        const auto tags = group.tags();
        std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
            return std::pair(tags[a].body, cell[a]) < std::pair(tags[b].body, cell[b]);
        });
        return order;
    }
    std::vector<std::int32_t> next(static_cast<std::size_t>(cells.size()) + 1, 0);
    for (const std::int64_t c : cell) ++next[c + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t i = 0; i < order.size(); ++i) order[next[cell[i]]++] = static_cast<std::int32_t>(i);
    return order;
}

}  // namespace

std::vector<Cluster> sort_in_space(ParticleGroup& group, double spacing, int threads) {
    std::vector<Cluster> clusters;
    const std::size_t owned = group.owned();
    if (owned == 0) {
        group.reorder({});
        return clusters;
    }
    const Cells cells(group, spacing);
    std::array<const double*, 3> x{};
    for (int axis = 0; axis < group.dimension(); ++axis) x[axis] = group.data(Field::position, axis);
    std::vector<std::int64_t> cell(owned);
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(owned); ++i)
        cell[i] = cells.of(x, static_cast<std::size_t>(i), group.dimension());

    std::vector<std::int32_t> order = order_by_cell(group, cells, cell);
    const auto tags = group.tags();
    const double longest = spacing * cluster_size;
    clusters.reserve(owned / cluster_size + owned / 64 + 1);
    for (std::size_t begin = 0; begin < owned;) {
        const std::int64_t strip = Cells::strip_of(cell[order[begin]]);
        const std::int32_t body = tags[order[begin]].body;
        std::size_t end = begin;
        while (end < owned && Cells::strip_of(cell[order[end]]) == strip && tags[order[end]].body == body) ++end;
        // Cells come in order along x already: few places change.
        for (std::size_t k = begin + 1; k < end; ++k) {
            const std::int32_t moving = order[k];
            std::size_t place = k;
            for (; place > begin && x[0][order[place - 1]] > x[0][moving]; --place) order[place] = order[place - 1];
            order[place] = moving;
        }
        while (begin < end) {
            Cluster cluster{static_cast<std::int32_t>(begin), 0};
            const double start = x[0][order[begin]];
            while (begin < end && cluster.count < cluster_size && x[0][order[begin]] - start < longest) {
                ++cluster.count;
                ++begin;
            }
            clusters.push_back(cluster);
        }
    }
    group.reorder(order, threads);
    return clusters;
}

}  // namespace dmp
