// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/output/fluid_fields.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// The Fourier mode with these numbers of waves n in the period of a fluid field: the factors of cos(k . x) and
/// sin(k . x), k = 2 pi n / L by axis, x from the low corner of the period. They are
///     2 / V SUM_i V_i (f_i - <f>) cos(k . x_i)   and the same with sin,
/// V the volume of the fluid and <f> its mean, which must not count where particles are not evenly spread.
class FourierMode {
  public:
    FourierMode(const std::array<int, 3>& waves, const ParticleSpace& space) : waves_(waves), space_(space) {}

    /// Length of a wave over the spacing [-].
    [[nodiscard]] double spacings() const;
    /// Factors of cos and sin for each component of probed_components of the array, in its unit. All ranks together.
    [[nodiscard]] std::vector<double> of(const FluidValues& array, const ParticleGroup& fluid,
                                         const Ranks& ranks) const;

  private:
    std::array<int, 3> waves_;
    const ParticleSpace& space_;
};

}  // namespace dmp::solver
