// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The spacing of representable positions: a power of two, a few parts in 10^16 of the scene's size. All positions
/// and periods are multiples of it, so that shifts by a period and separations of particles are exact. Results
/// therefore have the same bits regardless of when a particle is wrapped, when its neighbours are listed, and which
/// rank owns it.
class PositionQuantum {
  public:
    /// For positions in and around the box.
    explicit PositionQuantum(const ParticleSpace& space);

    /// The nearest multiple [m]. Exact up to some box sizes away; the rounding is coarser farther out.
    [[nodiscard]] double round(double x) const { return (x + magic_) - magic_; }
    [[nodiscard]] double size() const { return size_; }
    /// 1.5 2^52 quanta: adding it removes everything below a quantum from a double.
    [[nodiscard]] double magic() const { return magic_; }

  private:
    double size_, magic_;
};

/// The same space with its periods rounded to multiples of the quantum.
ParticleSpace with_whole_periods(const ParticleSpace& space, const PositionQuantum& quantum);

}  // namespace dmp::solver
