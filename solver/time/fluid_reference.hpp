// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "models/sph/void_closing.hpp"
#include "solver/neighbours/chambers.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/plan.hpp"
#include "solver/results/run_summary.hpp"
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
/// left out where walls or shapes move, because they can compress the fluid. Where the fluid consists of several
/// chambers (neighbours/chambers.hpp) each of them keeps its ratio; when they join or part, the targets of the new ones
/// are their present volumes, scaled so that the sum of the targets stays.
///
/// While there are voids what is subtracted is less than the level, by the suction that closes them (VoidClosing).
class FluidReference {
  public:
    struct Settings {
        bool subtracts;         ///< a level at all: not with a free surface, and not in the plain scheme
        bool keeps_volume;      ///< nothing moves that can change the fluid's volume
        double void_time;       ///< in which suction on voids grows and fades (VoidClosing) [s]
        bool chambers = false;  ///< there are several chambers, or may be
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

    /// By chamber, where there are several: the same. Empty where there is one.
    [[nodiscard]] std::span<const double> chamber_excess() const { return excess_of_chambers_; }
    /// Where there are several: what was taken off each, its liquid's mass [kg], and the place of one of its particles.
    [[nodiscard]] std::vector<ChamberDrift> chamber_drifts() const;

    /// After a search, of which the particles have their numbers (Field::chamber). All ranks must call it.
    void take_chambers(const FoundChambers& found, const ParticleStore& particles, const Ranks& ranks);

    /// The volume and the level at the start.
    void start(const VolumeSums& of_all_ranks);
    /// After each kick, of a step of dt [s]. `volumes`: by chamber, where there are several [m^3].
    void update(const VolumeSums& of_all_ranks, double dt, std::span<const ExactSum> volumes = {});
    /// After liquid has turned solid; all ranks must call it.
    void count(const ParticleStore& particles, const Ranks& ranks);

    void archive(Archive& file);

  private:
    /// One of several chambers.
    struct Chamber {
        double mass = 0;                ///< [kg]
        double rest_volume = 0;         ///< sum of m / rho0 [m^3]
        double ratio = 1;               ///< that is kept: sum of m / rho over rest_volume [-]
        double drift = 0;               ///< that was corrected [-]
        std::array<double, 3> place{};  ///< of one of its particles, at the last search [m]
        [[nodiscard]] double target() const { return ratio * rest_volume; }
    };
    void count_chambers(const ParticleStore& particles, const Ranks& ranks);
    void update_excess(double volume, std::span<const ExactSum> volumes);
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
    std::vector<Chamber> chambers_;  ///< empty where there is one
    std::vector<double> excess_of_chambers_;
};

/// Says that the mean density would have drifted by more than 5 % (FluidReference::density_drift): 0.1 to 3.9 % in
/// flows that were right, 10 % and more where particles were stirred.
std::optional<Warning> drift_warning(double drift);

/// Says that the mean density of one of several chambers would have drifted by more than 5 %, as of the whole, and
/// where the chamber is. A stirred chamber whose pressure stayed right had 2.9 % taken off in 10 s.
std::optional<Warning> chamber_warning(const ChamberDrift& chamber, int dimension);

}  // namespace dmp::solver
