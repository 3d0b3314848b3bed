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

/// Contact that prevents elastic bodies from passing through others and through themselves.
struct SpringContact {
    Repulsion repulsion{0};  ///< K = 0: none
    double range = 0;        ///< r* [m]
    bool of_solids = true;   ///< false: between solids and fluid alone

    [[nodiscard]] bool on() const { return repulsion.strength > 0 && range > 0; }
    /// Whether bodies repel themselves.
    [[nodiscard]] bool of_itself() const { return on() && of_solids; }
};

/// Nodes initially within this distance do not repel each other, if bonds are no longer than this: it includes both
/// ends of a bond, and the corners of a square of bonds.
inline double neighbourhood_of_contact(double range, double longest_bond) {
    return 1.5 * std::max(range, longest_bond);
}

/// Numbers of the points that are at most `distance` apart, sorted, with the lower one first.
std::vector<std::pair<int, int>> pairs_within(const std::vector<Vec>& points, int dimension, double distance);

/// Short-range repulsion between the nodes of one elastic body, so that it cannot pass through itself where it folds.
/// Pairs in `held_apart` do not repel: their springs control their distance, and there are no contact forces in the
/// initial state. (Contact between bodies, walls and fluid is computed in the sweeps; a body does not repel its own
/// periodic image.) Every rank computes this for all bodies, as it advances all of them: the lists of the sweeps omit
/// nodes of the same body.
template <int D>
class SelfContact {
  public:
    using Vectors = std::vector<Vector<double, D>>;

    /// `held_apart` as in BodyParts; `left_out` by node: 1 if the sweeps compute its contact (if empty: none).
    SelfContact(const SpringContact& contact, std::vector<std::pair<int, int>> held_apart,
                std::vector<std::uint8_t> left_out = {})
        : contact_(contact), held_apart_(std::move(held_apart)), left_out_(std::move(left_out)) {}

    [[nodiscard]] const std::vector<std::pair<int, int>>& held_apart() const { return held_apart_; }

    /// Adds the forces on nodes at these positions [N], in the order of the nodes' numbers: the result does not
    /// depend on when pairs were searched for.
    void add_forces(const Vectors& position, Vectors& force);

    /// Upper bound of the square of the highest frequency of nodes at these positions [1/s^2]
    /// (contact_stiffness.hpp); inverse masses by node [1/kg].
    [[nodiscard]] double rate(const Vectors& position, const std::vector<double>& inverse_mass);

  private:
    [[nodiscard]] bool moved_far(const Vectors& position) const;
    /// Lists the pairs that repel, or may do so before nodes have moved by half the skin.
    void search_around(const Vectors& position);

    SpringContact contact_;
    std::vector<std::pair<int, int>> held_apart_;
    std::vector<std::uint8_t> left_out_;
    std::vector<std::pair<int, int>> pairs_;  ///< sorted
    Vectors pruned_at_;                       ///< positions of nodes at the last search
};

}  // namespace dmp::solver
