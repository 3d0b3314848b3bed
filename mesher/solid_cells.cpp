// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/solid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "base/disjoint_sets.hpp"

namespace dmp::mesher {

namespace {

using BoxIndex = std::array<int, 3>;

/// Of a box: with less solid it is no cell. A smaller share makes bodies stiffer, a larger one softer, most of all when
/// they twist (docs/elastic.md).
constexpr double least_share(int dimension) { return dimension == 3 ? 0.2 : 0.25; }
/// A cell that has taken up its neighbours' solid keeps its particle so far inside its box [step]: else a node's share
/// of its mass would be negative.
constexpr double farthest_centroid = 0.49;

/// The boxes around a box, itself left out.
std::vector<BoxIndex> around(const BoxIndex& box, int dimension) {
    std::vector<BoxIndex> boxes;
    for (int k = dimension == 3 ? -1 : 0; k <= (dimension == 3 ? 1 : 0); ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
                if (i != 0 || j != 0 || k != 0) boxes.push_back({box[0] + i, box[1] + j, box[2] + k});
    return boxes;
}

class Builder {
  public:
    Builder(const BoxLattice& lattice, const SolidOnLattice& solid) : lattice_(lattice), solid_(solid) {}

    void look_at(const BoxIndex& box) {
        const Filling filling = solid_.filling(box);
        if (!(filling.volume > 0)) return;
        const bool is_cell = filling.volume >= least_share(lattice_.dimension) * lattice_.volume();
        if (!is_cell) {
            slivers_.emplace_back(box, filling);
            return;
        }
        number_.emplace(box, static_cast<int>(boxes_.size()));
        boxes_.push_back(box);
        result_.fillings.push_back(filling);
        if (filling.volume < (1 - 1e-9) * lattice_.volume()) ++result_.cut;
    }

    SolidCells finish() {
        give_slivers_away();
        make_cells();
        join_nodes();
        return std::move(result_);
    }

  private:
    void give_slivers_away() {
        std::vector<Filling> taken(boxes_.size());
        for (const auto& [box, filling] : slivers_) {
            int nearest = -1;
            double least = std::numeric_limits<double>::infinity();
            for (const BoxIndex& beside : around(box, lattice_.dimension)) {
                const auto found = number_.find(lattice_.in_period(beside));
                // Beyond a periodic side its solid is a period away.
                if (found == number_.end() || found->first != beside) continue;
                const double apart = (result_.fillings[found->second].centroid - filling.centroid).norm();
                if (apart >= least) continue;
                least = apart;
                nearest = found->second;
            }
            if (nearest < 0) {
                ++result_.lost;
                result_.lost_volume += filling.volume;
                continue;
            }
            ++result_.merged;
            taken[nearest].add(filling);
        }
        for (std::size_t n = 0; n < taken.size(); ++n)
            if (taken[n].volume > 0) result_.fillings[n].add(taken[n]);
    }

    void make_cells() {
        for (std::size_t n = 0; n < boxes_.size(); ++n) {
            Filling& filling = result_.fillings[n];
            const Vec middle = lattice_.middle(boxes_[n]);
            SolidCell cell;
            cell.particle = static_cast<int>(n);
            cell.size = lattice_.step;
            const Vec most = farthest_centroid * lattice_.step;
            cell.centroid = (filling.centroid - middle).cwiseMax(-most).cwiseMin(most);
            filling.centroid = middle + cell.centroid;
            cell.moment = filling.moment;
            result_.cells.push_back(cell);
        }
    }

    /// Corners of cells that share a face with solid on it are one node.
    void join_nodes() {
        const int corners = 1 << lattice_.dimension;
        const auto count = static_cast<int>(boxes_.size());
        DisjointSets nodes(static_cast<std::size_t>(count * corners)), pieces(static_cast<std::size_t>(count));
        for (int n = 0; n < count; ++n)
            for (int axis = 0; axis < lattice_.dimension; ++axis) {
                BoxIndex next = boxes_[n];
                ++next[axis];
                const auto found = number_.find(lattice_.in_period(next));
                if (found == number_.end() || found->second == n || !solid_.joined(boxes_[n], axis)) continue;
                pieces.join(n, found->second);
                for (int k = 0; k < corners; ++k)
                    if (k >> axis & 1) nodes.join(n * corners + k, found->second * corners + (k ^ 1 << axis));
            }
        std::map<std::size_t, int> node_of, piece_of;
        for (int n = 0; n < count; ++n) {
            result_.piece.push_back(
                piece_of.try_emplace(pieces.find(n), static_cast<int>(piece_of.size())).first->second);
            for (int k = 0; k < corners; ++k) {
                const auto [known, is_new] =
                    node_of.try_emplace(nodes.find(n * corners + k), static_cast<int>(result_.nodes.size()));
                result_.cells[n].node[k] = known->second;
                BoxIndex corner = boxes_[n];
                for (int axis = 0; axis < lattice_.dimension; ++axis) corner[axis] += k >> axis & 1;
                // Nodes on a periodic side are those of its low end.
                const BoxIndex at = lattice_.in_period(corner);
                for (int axis = 0; axis < lattice_.dimension; ++axis)
                    if (at[axis] != corner[axis]) result_.cells[n].periods |= SolidCell::period_bit(k, axis);
                if (is_new) result_.nodes.push_back({lattice_.corner(at)});
            }
        }
        result_.pieces = static_cast<int>(piece_of.size());
    }

    const BoxLattice& lattice_;
    const SolidOnLattice& solid_;
    std::map<BoxIndex, int> number_;
    std::vector<BoxIndex> boxes_;  ///< of the cells
    std::vector<std::pair<BoxIndex, Filling>> slivers_;
    SolidCells result_;
};

}  // namespace

void Filling::add(const Filling& other) {
    const double both = volume + other.volume;
    const Vec middle = (volume * centroid + other.volume * other.centroid) / both;
    const auto about_middle = [&](const Filling& each) {
        return Vec(each.volume * (each.moment + (each.centroid - middle).cwiseAbs2()));
    };
    moment = (about_middle(*this) + about_middle(other)) / both;
    centroid = middle;
    volume = both;
}

double SolidCells::volume() const {
    return std::accumulate(fillings.begin(), fillings.end(), 0.0,
                           [](double sum, const Filling& filling) { return sum + filling.volume; });
}

SolidCells solid_cells(const BoxLattice& lattice, const std::array<int, 3>& first, const std::array<int, 3>& last,
                       const SolidOnLattice& solid) {
    Builder builder(lattice, solid);
    for (int k = first[2]; k < last[2]; ++k)
        for (int j = first[1]; j < last[1]; ++j)
            for (int i = first[0]; i < last[0]; ++i) builder.look_at({i, j, k});
    return builder.finish();
}

}  // namespace dmp::mesher
