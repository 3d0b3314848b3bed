// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The smallest step a position can make: a power of two, a few parts in 10^16 of the scene's size. All positions and
/// periods are whole multiples of it, so that moving a particle by a period, and the separation of two particles, are
/// exact: it changes no bit of a result where a particle was wrapped, when its neighbours were listed, or which rank
/// holds it.
class PositionQuantum {
  public:
    /// For positions in and around the box.
    explicit PositionQuantum(const ParticleSpace& space);

    /// The nearest multiple [m]. Exact for anything up to some box sizes away; farther out it rounds less finely.
    [[nodiscard]] double round(double x) const { return (x + magic_) - magic_; }
    [[nodiscard]] double size() const { return size_; }
    /// 1.5 2^52 quanta: adding it pushes everything below a quantum out of a double.
    [[nodiscard]] double magic() const { return magic_; }

  private:
    double size_, magic_;
};

/// The same space with its periods made whole multiples of the quantum.
ParticleSpace with_whole_periods(const ParticleSpace& space, const PositionQuantum& quantum);

}  // namespace dmp::solver
