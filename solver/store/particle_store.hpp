// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"
#include "solver/store/position_quantum.hpp"

namespace dmp::solver {

inline constexpr std::array<PartKind, 3> all_kinds{PartKind::fluid, PartKind::rigid, PartKind::elastic};

/// The particles of a run, one group per kind, and the space that contains them.
class ParticleStore {
  public:
    /// This rank's share of the particles, regardless of position. They are at rest and have the mass of their volume
    /// at the density of the fluid (`density` by part number [kg/m^3]).
    ParticleStore(const ParticleSet& set, const std::vector<double>& density, const Ranks& ranks = Ranks::alone());

    [[nodiscard]] ParticleGroup& of(PartKind kind) { return groups_[static_cast<std::size_t>(kind)]; }
    [[nodiscard]] const ParticleGroup& of(PartKind kind) const { return groups_[static_cast<std::size_t>(kind)]; }
    [[nodiscard]] ParticleGroup& fluid() { return of(PartKind::fluid); }
    [[nodiscard]] const ParticleGroup& fluid() const { return of(PartKind::fluid); }
    [[nodiscard]] std::array<ParticleGroup, 3>& groups() { return groups_; }
    [[nodiscard]] const std::array<ParticleGroup, 3>& groups() const { return groups_; }

    [[nodiscard]] const ParticleSpace& space() const { return space_; }
    [[nodiscard]] const PositionQuantum& quantum() const { return quantum_; }
    [[nodiscard]] int dimension() const { return space_.dimension; }
    [[nodiscard]] std::size_t owned() const;
    [[nodiscard]] std::size_t bytes() const;

  private:
    PositionQuantum quantum_;
    ParticleSpace space_;
    std::array<ParticleGroup, 3> groups_;
};

}  // namespace dmp::solver
