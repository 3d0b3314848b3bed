// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/contact/repulsion.hpp"
#include "particles/cell_grid.hpp"
#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What keeps spring bodies from passing through others and through themselves.
struct SpringContact {
    Repulsion repulsion{0};  ///< K = 0: none
    double range = 0;        ///< r* [m]

    [[nodiscard]] bool on() const { return repulsion.strength > 0 && range > 0; }
};

/// How near nodes must have been drawn not to repel, for bonds no longer than this: both ends of a bond, and the
/// corners of a square of bonds.
inline double neighbourhood_of_contact(double range, double longest_bond) {
    return 1.5 * std::max(range, longest_bond);
}

/// Numbers of the points that are no farther apart than `distance`, the lower one first, in order.
std::vector<std::pair<int, int>> pairs_within(const std::vector<Vec>& points, int dimension, double distance);

/// Short-range repulsion between the nodes of one spring body, so that it does not pass through itself where it folds.
/// Nodes that are held apart do not repel: their distance is their springs' business, and a body as drawn feels
/// nothing. (Bodies, walls and fluid meet in the sweeps; a body and its own periodic image do not.) Every rank moves
/// every body, and so does this: no node is in the sweeps' lists for its own body.
template <int D>
class SelfContact {
  public:
    using Vectors = std::vector<Vector<double, D>>;

    /// `held_apart` as of BodyParts; `left_out` by node: 1 for those that the sweeps keep apart (none given: none).
    SelfContact(const SpringContact& contact, std::vector<std::pair<int, int>> held_apart,
                std::vector<std::uint8_t> left_out = {})
        : contact_(contact), held_apart_(std::move(held_apart)), left_out_(std::move(left_out)) {}

    [[nodiscard]] const std::vector<std::pair<int, int>>& held_apart() const { return held_apart_; }

    /// Adds the forces of nodes at these places [N], in the order of the nodes' numbers: it does not matter when pairs
    /// were looked for.
    void add_forces(const Vectors& position, Vectors& force);

    /// Bound of the square of the highest frequency of nodes at these places [1/s^2] (contact_stiffness.hpp); inverse
    /// masses by node [1/kg].
    [[nodiscard]] double rate(const Vectors& position, const std::vector<double>& inverse_mass);

  private:
    [[nodiscard]] bool moved_far(const Vectors& position) const;
    /// Lists the pairs that repel or may before nodes have moved by half the skin.
    void search_around(const Vectors& position);

    SpringContact contact_;
    std::vector<std::pair<int, int>> held_apart_;
    std::vector<std::uint8_t> left_out_;
    std::vector<std::pair<int, int>> pairs_;  ///< sorted
    Vectors pruned_at_;                       ///< where nodes were then
};

}  // namespace dmp::solver
