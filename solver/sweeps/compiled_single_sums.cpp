// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The sums in mixed precision for one vector unit, under the rules of compiled_sweeps.cpp.
#include <algorithm>
#include <cmath>

#include "particles/kernels.hpp"
#include "solver/sweeps/lanes.hpp"
#include "solver/sweeps/single_sums.hpp"
#include "solver/sweeps/single_sweep.hpp"

namespace dmp {

namespace {

template <class L, int D, class Kernel>
class SumsInSingle final : public SingleSums {
  public:
    explicit SumsInSingle(const PairSettings& settings)
        : settings_(settings),
          units_{settings.spacing, settings.sound_speed, settings.density},
          points_(units_, D),
          kernel_(settings.support / settings.spacing),
          diffusion_(settings.density_diffusion, settings.support / settings.spacing, 1),
          shifting_(settings.shifting, settings.support / settings.spacing, 1, kernel_) {}

    void forces(ParticleStore& particles, const ClusterList& list, const OrderFree& rounding) override {
        points_.fill(particles.fluid(), settings_.threads);
        // As largest_force of the double sums, in these units.
        const double viscous = settings_.viscosity / (units_.density * units_.sound_speed * units_.length);
        sweep(particles, list, 2 * (0.1 + 0.1 * viscous) * steepest()).forces(rounding);
    }

    void density_rates(ParticleStore& particles, const ClusterList& list, const OrderFree& rate_rounding,
                       const OrderFree& shift_rounding) override {
        points_.fill_velocities(particles.fluid(), settings_.threads);
        auto rates = sweep(particles, list, 1.2 * steepest());
        const bool diffusion = settings_.density_diffusion > 0, shifting = settings_.shifting > 0;
        if (diffusion && shifting) {
            rates.template density_rates<true, true>(diffusion_, shifting_, rate_rounding, shift_rounding);
        } else if (diffusion) {
            rates.template density_rates<true, false>(diffusion_, shifting_, rate_rounding, shift_rounding);
        } else if (shifting) {
            rates.template density_rates<false, true>(diffusion_, shifting_, rate_rounding, shift_rounding);
        } else {
            rates.template density_rates<false, false>(diffusion_, shifting_, rate_rounding, shift_rounding);
        }
    }

  private:
    [[nodiscard]] auto sweep(ParticleStore& particles, const ClusterList& list, double largest_term) const {
        return SingleSweep<L, D, Kernel>(particles, list, points_, units_, kernel_, largest_term, settings_.threads);
    }
    /// Largest |dW/dr| of the kernel.
    [[nodiscard]] double steepest() const {
        double largest = 0;
        for (int k = 1; k < 100; ++k) {
            const double r = 0.01 * k * settings_.support / settings_.spacing;
            largest = std::max(largest, -kernel_.slope(r) * r);
        }
        return largest;
    }

    PairSettings settings_;
    SingleUnits units_;
    SinglePoints points_;
    Kernel kernel_;
    DensityDiffusion diffusion_;
    Shifting<Kernel> shifting_;
};

template <class L, int D>
std::unique_ptr<SingleSums> sums_in(const PairSettings& settings) {
    if (settings.kernel == KernelKind::lucy) return std::make_unique<SumsInSingle<L, D, Lucy<D>>>(settings);
    return std::make_unique<SumsInSingle<L, D, WendlandC2<D>>>(settings);
}

}  // namespace

std::unique_ptr<SingleSums> DMP_SINGLE_SUMS_FOR(const PairSettings& settings, int dimension) {
    return dimension == 3 ? sums_in<SingleLanes, 3>(settings) : sums_in<SingleLanes, 2>(settings);
}

}  // namespace dmp
