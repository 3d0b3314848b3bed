// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/sweeps/order_free.hpp"
#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp {

/// The sums over pairs of fluid particles in mixed precision, for the sweeps above.
class SingleSums {
  public:
    virtual ~SingleSums() = default;
    /// force [N] by the fluid alone.
    virtual void forces(ParticleStore& particles, const ClusterList& list, const OrderFree& rounding) = 0;
    /// density_rate [kg/m^3/s] and shift [1/m] by the fluid alone.
    virtual void density_rates(ParticleStore& particles, const ClusterList& list, const OrderFree& rate_rounding,
                               const OrderFree& shift_rounding) = 0;
};

/// For one vector unit each; only to be called on a processor that has it.
std::unique_ptr<SingleSums> single_sums_for_avx512(const PairSettings& settings, int dimension);
std::unique_ptr<SingleSums> single_sums_for_avx2(const PairSettings& settings, int dimension);
/// On processors that are no x86.
std::unique_ptr<SingleSums> single_sums_for_this_processor(const PairSettings& settings, int dimension);

}  // namespace dmp
