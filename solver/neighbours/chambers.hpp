// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/neighbours/neighbours.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Chambers are the connected parts of the fluid: particles are linked that are nearer to each other than 1.6 spacings,
/// which no two are on both sides of a wall of two rows. Chambers that an elastic body separates which can move count
/// as one, as it hands the volume of one to the other.
struct ChamberLinks {
    static double reach(double spacing) { return 1.6 * spacing; }  ///< [m]
    /// A particle with one on each side along all axes. Fewer are no chamber: single particles in a gap, or spray.
    static std::int64_t fewest_particles(int dimension) { return static_cast<std::int64_t>(std::pow(3, dimension)); }
};

/// The chambers that a search has found, and which of them have liquid of which chambers of the search before.
struct FoundChambers {
    struct Shared {
        std::int32_t before, now;
        std::int64_t particles;
        friend bool operator==(const Shared&, const Shared&) = default;
    };
    std::vector<Shared> shared;                 ///< by `before`, then by `now`
    std::vector<std::array<double, 3>> places;  ///< by chamber: of its particle with the lowest id [m]

    [[nodiscard]] std::size_t count() const { return places.size(); }
    /// Each chamber has all liquid of one from before and nothing else.
    [[nodiscard]] bool same_as_before() const;
};

/// Finds the chambers and writes their numbers into Field::chamber of owned particles, which has those of the search
/// before. They are numbered by their lowest ids. Few particles apart from all others belong to the chamber that most
/// of their last one's liquid is in. The same on any number of ranks, all of which must call it. The list must hold all
/// pairs within reach.
/// @param moves by number of the elastic body: whether it can move
FoundChambers find_chambers(ParticleStore& particles, Neighbours& neighbours, double spacing,
                            const std::vector<bool>& moves);

}  // namespace dmp::solver
