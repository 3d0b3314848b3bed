// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "models/sph/void_closing.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/plan.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/sweeps/fluid_passes.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The fluid of all ranks as a whole, as the corrected scheme refers to it: the level and the hydrostatic slope of its
/// pressure, which the sums over pairs subtract, and its volume.
///
/// Densities follow the flow particle by particle, and errors of their rates add up: in the heart valve at 1 mm their
/// mean rose by 4.5 % in one beat. But the volume between solids that keep theirs is constant. So in each step all
/// densities change by the same share, such that the sum of m / rho keeps its ratio to the sum of m / rho0. That is
/// left out where walls or shapes move, because they can compress the fluid.
///
/// While there are voids what is subtracted is less than the level, by the suction that closes them (VoidClosing).
class FluidReference {
  public:
    struct Settings {
        bool subtracts;     ///< a level at all: not with a free surface, and not in the plain scheme
        bool keeps_volume;  ///< nothing moves that can change the fluid's volume
        double void_time;   ///< in which suction on voids grows and fades (VoidClosing) [s]
    };
    FluidReference(const Settings& settings, std::vector<double> rest_density, const ParticleStore& particles,
                   const Ranks& ranks);

    /// Of the liquid that has not turned solid [kg].
    [[nodiscard]] double mass() const { return mass_; }
    /// Whether there is a level to subtract.
    [[nodiscard]] bool subtracts() const { return settings_.subtracts; }
    /// With the hydrostatic slope in the acceleration g; zero where no liquid is left.
    [[nodiscard]] ReferencePressure pressure(const ParticleStore& particles, const std::array<double, 3>& g) const;
    /// On voids [Pa]; 0 where there is none.
    [[nodiscard]] double suction() const { return suction_; }
    /// By what share the densities are too high [-].
    [[nodiscard]] double density_excess() const { return excess_; }
    /// What those shares add up to since the start: the drift that was corrected [-].
    [[nodiscard]] double density_drift() const { return drift_; }

    /// The volume and the level at the start.
    void start(const VolumeSums& of_all_ranks);
    /// After each kick, of a step of dt [s].
    void update(const VolumeSums& of_all_ranks, double dt);
    /// After liquid has turned solid; all ranks must call it.
    void count(const ParticleStore& particles, const Ranks& ranks);

    void archive(Archive& file);

  private:
    void update_level(const VolumeSums& sums);
    void update_suction(const VolumeSums& sums, double dt);

    Settings settings_;
    std::vector<double> rest_density_;  ///< by part [kg/m^3]
    double mass_ = 0;                   ///< [kg]
    double rest_volume_ = 0;            ///< sum of m / rho0 [m^3]
    double mean_density_ = 0;           ///< at the start, at rest density [kg/m^3]
    double volume_ratio_ = 0;           ///< at the start, sum of m / rho over sum of m / rho0 [-]
    double level_ = 0;                  ///< mean pressure [Pa]
    double suction_ = 0;                ///< by which what is subtracted is less, while there are voids [Pa]
    double excess_ = 0, drift_ = 0;
};

/// Says that the mean density would have drifted by more than 5 % (FluidReference::density_drift): 0.1 to 3.9 % in
/// flows that were right, 10 % and more where particles were stirred.
std::optional<Warning> drift_warning(double drift);

}  // namespace dmp::solver
