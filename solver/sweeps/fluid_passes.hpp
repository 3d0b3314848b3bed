// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "models/sph/liquid_state.hpp"
#include "solver/parallel/exact_sum.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/sweeps/reference_pressure.hpp"

namespace dmp::solver {

/// Extremes found during a pass over the fluid.
struct PassExtremes {
    double largest_speed = 0;                  ///< [m/s]; infinite if any velocity is not finite
    double longest_shift = 0;                  ///< [m]
    double density_low = 0, density_high = 0;  ///< relative to the rest density [-]
};

/// Sums over the new speeds, computed during a kick.
struct SpeedSums {
    double largest = 0;      ///< [m/s]; infinite if any velocity is not finite
    ExactSum fourth_powers;  ///< [m^4/s^4]
};

/// Displacement of a particle by shifting, per unit of its sum.
struct ShiftStep {
    double per_sum = 0;  ///< [m^2]
    double longest = 0;  ///< [m]
};

/// Sums over the fluid's volumes, the same bits in any order.
struct VolumeSums {
    ExactSum volume;        ///< [m^3]
    ExactSum pressure;      ///< volume times reduced pressure [J]
    ExactSum square;        ///< volume times the square of reduced pressure [J Pa]
    ExactSum beside_voids;  ///< number of particles (VoidClosing)
};

/// Passes over single particles between the pair sweeps of a fluid step. Each combines as many updates as possible,
/// because these passes are limited by memory traffic, not by arithmetic.
class FluidPasses {
  public:
    /// Equations of state by part number.
    FluidPasses(std::vector<LiquidState> state_of_part, int threads);

    /// x += dt v, rho += dt drho/dt (also for solids that carry a density), then pressure and volume.
    void drift_to_middle(ParticleStore& particles, double dt) const;
    /// v += dt (F / m + g). If the expected largest speed of all ranks is given (not 0), also sums the fourth powers
    /// of the new speeds, rounded for that speed.
    [[nodiscard]] SpeedSums kick(ParticleGroup& fluid, double dt, const std::array<double, 3>& g,
                                 double expected_speed = 0) const;
    /// Sum of the fourth powers of the speeds [m^4/s^4], for the largest speed of all ranks; the same bits in any
    /// order.
    [[nodiscard]] ExactSum fourth_powers_of_speeds(const ParticleGroup& fluid, double largest_speed) const;
    /// True if the sum for the expected largest speed has the same bits as that for the actual one.
    [[nodiscard]] static bool sum_alike(double expected_speed, double largest_speed);
    /// x += dt v + shift, rho += dt drho/dt. Returns the longest shift and the extremes of density.
    [[nodiscard]] PassExtremes drift_to_end(ParticleStore& particles, double dt, const ShiftStep& shift) const;

    /// x += dt v alone.
    void drift(ParticleStore& particles, double dt) const;
    /// x += shift; velocity and density follow by their gradients, v += G shift, rho += g . shift; rho += dt drho/dt,
    /// and then loses the share `density_excess`, or where there are several chambers that of its own. The fluid's
    /// momentum changes by `momentum`, rounded for the largest momentum of a particle [N s].
    struct Shifted {
        PassExtremes extremes;
        std::array<ExactSum, 3> momentum;  ///< [N s]
    };
    [[nodiscard]] Shifted shift(ParticleStore& particles, double dt, const ShiftStep& shift, double largest_momentum,
                                double density_excess, std::span<const double> excess_of_chambers = {}) const;
    /// v += change
    void add_to_velocities(ParticleGroup& fluid, const std::array<double, 3>& change) const;
    [[nodiscard]] VolumeSums volume_sums(const ParticleGroup& fluid, double largest_volume,
                                         double largest_pressure) const;
    /// By chamber: the sum of volumes [m^3], the same bits in any order.
    [[nodiscard]] static std::vector<ExactSum> chamber_volumes(const ParticleGroup& fluid, std::size_t chambers,
                                                               double largest_volume);
    /// From the next update of pressures on.
    void subtract(const ReferencePressure& reference) { reference_ = reference; }
    [[nodiscard]] const ReferencePressure& subtracted() const { return reference_; }

    /// Sets the transport velocity minus the fluid velocity, for a step dt in which the shift moved the particles.
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
    template <int D>
    [[nodiscard]] Shifted shift_and_interpolate(ParticleStore& particles, const ShiftStep& shift,
                                                double largest_momentum) const;
    void update_reduced_pressure(ParticleGroup& fluid) const;
    void update_density(ParticleGroup& group, double dt) const;
    template <class DensityOf>
    void update_pressure(ParticleGroup& group, const DensityOf& density_of) const;

    ReferencePressure reference_;
    std::vector<LiquidState> state_of_part_;
    bool one_state_;  ///< all parts have the same equation of state
    int threads_;
};

}  // namespace dmp::solver
