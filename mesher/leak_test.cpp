// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/leak_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace dmp::mesher {

namespace {

constexpr std::uint8_t wall_cell = 1, fluid_cell = 2, body_cell = 4, occupied = 8, flooded = 16;
constexpr double reach_of_walls = 0.6, reach_of_others = 0.5;  // of a particle's cube, from its centre [spacings]
constexpr int margin_cells = 4;                                // around the outermost particles
constexpr int room_cells = 2;  // how far a room is from the cubes of particles: a spacing

/// The box cut into cells of half a spacing.
class Flood {
  public:
    explicit Flood(const ParticleSet& set) : set_(set) {
        std::size_t cells = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (static_cast<int>(axis) >= set.dimension) continue;
            const auto at = static_cast<Eigen::Index>(axis);
            double low = set.box.low[at], high = set.box.high[at];
            for (const bool upper : {false, true}) {
                open_.at(axis).at(upper ? 1 : 0) = !set.periodic.at(axis) && !set.mirrored.at(axis).at(upper ? 1 : 0);
                if (!open_.at(axis).at(upper ? 1 : 0)) continue;
                (upper ? high : low) += (upper ? 1 : -1) * margin_cells * set.spacing / 2;
            }
            count_.at(axis) = std::max(1L, std::lround((high - low) / (set.spacing / 2)));
            low_.at(axis) = low;
            edge_.at(axis) = (high - low) / static_cast<double>(count_.at(axis));
            cells *= static_cast<std::size_t>(count_.at(axis));
        }
        stride_ = {1, count_[0], count_[0] * count_[1]};
        cell_.assign(cells, 0);
        for (std::size_t i = 0; i < set.size(); ++i) {
            const PartKind kind = set.kind(i);
            const std::uint8_t mark = kind == PartKind::rigid   ? wall_cell
                                      : kind == PartKind::fluid ? fluid_cell
                                                                : body_cell;
            for_each_cell(i, [&](std::uint8_t& cell) { cell |= mark; });
        }
    }

    MeshReport::LeakLine run() {
        start();
        while (!front_.empty()) {
            const std::size_t here = front_.back();
            front_.pop_back();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto stride = static_cast<std::size_t>(stride_.at(axis));
                const long index = static_cast<long>(here) / stride_.at(axis) % count_.at(axis);
                if (index > 0) visit(here - stride);
                if (index + 1 < count_.at(axis)) visit(here + stride);
            }
        }
        for (std::size_t i = 0; i < set_.size(); ++i) {
            if (set_.kind(i) != PartKind::fluid) continue;
            bool reached = false;
            for_each_cell(i, [&](std::uint8_t cell) { reached = reached || (cell & flooded) != 0; });
            if (!reached) continue;
            if (line_.particles == 0) line_.where = set_.position[i];
            ++line_.particles;
        }
        return line_;
    }

  private:
    /// The cells whose centres lie in a particle's cube, around a periodic side too.
    template <class Visit>
    void for_each_cell(std::size_t i, const Visit& visit) {
        const double reach = (set_.kind(i) == PartKind::rigid ? reach_of_walls : reach_of_others) * set_.spacing;
        std::array<long, 3> first{}, last{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (static_cast<int>(axis) >= set_.dimension) continue;
            const double at = set_.position[i][static_cast<Eigen::Index>(axis)] - low_.at(axis);
            first.at(axis) = static_cast<long>(std::ceil((at - reach) / edge_.at(axis) - 0.5 - 1e-9));
            last.at(axis) = static_cast<long>(std::floor((at + reach) / edge_.at(axis) - 0.5 + 1e-9));
            if (set_.periodic.at(axis)) continue;
            first.at(axis) = std::max(first.at(axis), 0L);
            last.at(axis) = std::min(last.at(axis), count_.at(axis) - 1);
        }
        const auto around = [&](long index, std::size_t axis) {
            const long count = count_.at(axis);
            return (index % count + count) % count * stride_.at(axis);
        };
        for (long z = first[2]; z <= last[2]; ++z)
            for (long y = first[1]; y <= last[1]; ++y)
                for (long x = first[0]; x <= last[0]; ++x)
                    visit(cell_[static_cast<std::size_t>(around(x, 0) + around(y, 1) + around(z, 2))]);
    }

    /// Calls visit(first cell) for each line of cells along an axis; the next ones are a stride apart.
    template <class Visit>
    void for_each_line(std::size_t axis, const Visit& visit) {
        const auto stride = static_cast<std::size_t>(stride_.at(axis));
        const std::size_t block = stride * static_cast<std::size_t>(count_.at(axis));
        for (std::size_t start = 0; start < cell_.size(); start += block)
            for (std::size_t first = start; first < start + stride; ++first) visit(first);
    }

    /// Marks what is near any particle, one axis after the other.
    void occupy() {
        for (std::uint8_t& cell : cell_)
            if (cell != 0) cell |= occupied;
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(set_.dimension); ++axis) {
            const long count = count_.at(axis);
            const auto stride = static_cast<std::size_t>(stride_.at(axis));
            const bool wraps = set_.periodic.at(axis);
            std::vector<std::uint8_t> line(static_cast<std::size_t>(count));
            for_each_line(axis, [&](std::size_t first) {
                for (std::size_t k = 0; k < line.size(); ++k) line[k] = cell_[first + k * stride] & occupied;
                for (long k = 0; k < count; ++k) {
                    if (line[static_cast<std::size_t>(k)] == 0) continue;
                    for (long near = k - room_cells; near <= k + room_cells; ++near) {
                        if (!wraps && (near < 0 || near >= count)) continue;
                        const auto position = static_cast<std::size_t>((near + room_cells * count) % count);
                        cell_[first + position * stride] |= occupied;
                    }
                }
            });
        }
    }

    void start() {
        occupy();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t to_last =
                static_cast<std::size_t>(count_.at(axis) - 1) * static_cast<std::size_t>(stride_.at(axis));
            for_each_line(axis, [&](std::size_t first) {
                if (open_.at(axis)[0]) visit(first);
                if (open_.at(axis)[1]) visit(first + to_last);
            });
        }
        for (std::size_t k = 0; k < cell_.size(); ++k)
            if ((cell_[k] & occupied) == 0) visit(k);
    }

    void visit(std::size_t k) {
        std::uint8_t& cell = cell_[k];
        if ((cell & (wall_cell | flooded)) != 0) return;
        cell |= flooded;
        ++line_.cells;
        if ((cell & fluid_cell) == 0) front_.push_back(k);
    }

    const ParticleSet& set_;
    std::array<double, 3> low_{}, edge_{1, 1, 1};
    std::array<long, 3> count_{1, 1, 1}, stride_{};
    std::array<std::array<bool, 2>, 3> open_{};
    std::vector<std::uint8_t> cell_;
    std::vector<std::size_t> front_;
    MeshReport::LeakLine line_;
};

}  // namespace

MeshReport::LeakLine find_leaks(const ParticleSet& set) { return Flood(set).run(); }

}  // namespace dmp::mesher
