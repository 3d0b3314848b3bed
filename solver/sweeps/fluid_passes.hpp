// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "models/sph/liquid_state.hpp"
#include "solver/parallel/exact_sum.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

/// What a pass over the fluid found on the way.
struct PassExtremes {
    double largest_speed = 0;                  ///< [m/s]; infinite when any velocity is not finite
    double longest_shift = 0;                  ///< [m]
    double density_low = 0, density_high = 0;  ///< relative to the rest density [-]
};

/// What a kick finds of the new speeds on the way.
struct SpeedSums {
    double largest = 0;      ///< [m/s]; infinite when any velocity is not finite
    ExactSum fourth_powers;  ///< [m^4/s^4]
};

/// How far shifting moves a particle for a unit of its sum.
struct ShiftStep {
    double per_sum = 0;  ///< [m^2]
    double longest = 0;  ///< [m]
};

/// The passes over particles, one by one, that a fluid step makes between its sweeps over pairs. Each does in one go
/// what it can while a particle's values are at hand: they cost memory traffic, not arithmetic.
class FluidPasses {
  public:
    /// Equations of state by part number.
    FluidPasses(std::vector<LiquidState> state_of_part, int threads);

    /// x += dt v, rho += dt drho/dt (also of solids that carry a density), then pressure and volume.
    void drift_to_middle(ParticleStore& particles, double dt) const;
    /// v += dt (F / m + g). With the largest speed of all ranks that is expected, the fourth powers of the new speeds
    /// are summed on the way, as they would be for that speed; with none (0) they are not.
    [[nodiscard]] SpeedSums kick(ParticleGroup& fluid, double dt, const std::array<double, 3>& g,
                                 double expected_speed = 0) const;
    /// Sum of the fourth powers of the speeds [m^4/s^4], the largest of all ranks at hand; the same bits in any order.
    [[nodiscard]] ExactSum fourth_powers_of_speeds(const ParticleGroup& fluid, double largest_speed) const;
    /// Whether a kick that expected one largest speed and found another summed the same bits.
    [[nodiscard]] static bool sum_alike(double expected_speed, double largest_speed);
    /// x += dt v + shift, rho += dt drho/dt. What it finds: the longest shift and the extremes of density.
    [[nodiscard]] PassExtremes drift_to_end(ParticleStore& particles, double dt, const ShiftStep& shift) const;

    /// Velocity of transport less the fluid's own, of a step dt whose particles were moved by the shift.
    void note_transport(ParticleGroup& fluid, double dt, const ShiftStep& shift) const;

    /// Pressure and volume from density.
    void update_pressure(ParticleStore& particles) const;
    [[nodiscard]] PassExtremes extremes(const ParticleGroup& fluid) const;

  private:
    template <int D>
    [[nodiscard]] PassExtremes drift_and_shift(ParticleStore& particles, double dt, const ShiftStep& shift) const;
    template <class DensityOf>
    void update_density_range(const ParticleGroup& fluid, const DensityOf& density_of, PassExtremes& extremes) const;
    template <bool sums_powers>
    [[nodiscard]] SpeedSums kick_and_sum(ParticleGroup& fluid, double dt, const std::array<double, 3>& g,
                                         double expected_speed) const;
    void update_density(ParticleGroup& group, double dt) const;
    template <class DensityOf>
    void update_pressure(ParticleGroup& group, const DensityOf& density_of) const;

    std::vector<LiquidState> state_of_part_;
    bool one_state_;  ///< all parts share one equation
    int threads_;
};

}  // namespace dmp::solver
