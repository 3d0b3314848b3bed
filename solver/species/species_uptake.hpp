// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/transport/species_uptake.hpp"
#include "solver/parallel/exact_sum.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What the particles of some parts take up of one species (FirstOrderUptake). Amounts are taken in whole quanta and
/// added up without rounding, by part: the amount in all particles and what was taken up is the same to the last bit.
/// Rounding to a quantum is an error of 2^-46 of the largest amount in a particle and step, at most.
class SpeciesUptake {
  public:
    /// The two times of a step at which FirstOrderUptake takes its shares.
    enum class When { before_supply, after_supply };

    /// `rates` by part number [1/s]; 0: none. `largest_amount` in a particle: of its quantum are all amounts.
    SpeciesUptake(int species, const std::vector<double>& rates, double largest_amount, int threads);

    /// The parts' particles lose their share of what is taken up during dt.
    void take(ParticleStore& particles, double dt, When when);
    /// The share of all that comes in during dt that a part's particles keep.
    [[nodiscard]] double share_kept(std::uint16_t part, double dt) const;
    /// What this part (any part: none given) has taken up since the start. All ranks take part.
    [[nodiscard]] double taken(const Ranks& ranks, std::optional<std::uint16_t> part = {}) const;
    /// All ranks take part. `name`: of the species.
    void archive(Archive& file, const std::string& name, const Ranks& ranks);

  private:
    struct OfPart {
        std::uint16_t part = 0;
        FirstOrderUptake law{};
        ExactSum taken;  ///< of particles while they were this rank's
    };

    int species_;
    double largest_amount_;
    int threads_;
    std::vector<OfPart> parts_;
};

}  // namespace dmp::solver
