// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/errors.hpp"
#include "scene/scene.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/species/species_uptake.hpp"
#include "solver/state/archive.hpp"
#include "solver/sweeps/fluid_passes.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The concentrations of a step cannot be found.
class UnsolvedSpecies : public DivergenceError {
  public:
    using DivergenceError::DivergenceError;
};

/// One species as the solver has it.
struct CarriedSpecies {
    /// A part whose surface is held at a concentration, or, of rigid ones, gives off a flux.
    struct Surface {
        std::uint16_t part = 0;
        PartKind kind = PartKind::rigid;
        Expression value;
        bool held = true;
    };
    int number = 0;
    double diffusivity = -1;  ///< of all fluid particles [m^2/s]; negative: by particle
    bool with_rigid = false, with_elastic = false;
    std::vector<Surface> surfaces;
    double largest_amount = 0;         ///< that a particle is expected to hold
    double largest_concentration = 0;  ///< that is given, at the start or at a surface
    bool has_flux = false;             ///< from a surface
    double largest_diffusivity = 0;    ///< [m^2/s]
};

/// Species that are dissolved in the fluid, go along with its particles and diffuse (models/transport/). A particle
/// holds an amount w; its concentration is w over the volume V that its mass has at rest, so that a liquid's
/// compression by a per cent does not show in it. Amounts are whole multiples of one quantum, and so are those that
/// particles hand to each other: the amount in all particles stays the same to the last bit.
/// Shifting moves particles relative to the fluid. What is dissolved does not go along: a particle takes the
/// concentration of where it comes to. Amounts would change by that, in all, as any quadrature's with its points; the
/// excess is taken from the particles in proportion to what they have taken up or given in the step, so that nothing
/// changes where concentrations are even (as semi-Lagrangian schemes do: Bermejo & Conde 2002). What rounding leaves of
/// it, half a quantum a particle at most, waits for the next step.
/// Solids whose surface is held at a concentration, and walls that give off a flux, keep the account of what they have
/// taken (less what they gave) as their own amount. Solids are closed otherwise; those with a diffusivity take part
/// like the fluid, and conduct within themselves. What parts take up (SpeciesUptake) leaves the particles.
class SpeciesTransport {
  public:
    /// Declares the fields and fills them. `rest_density` by part number. Throws InputError where a formula gives no
    /// concentration.
    SpeciesTransport(const Scene& scene, const ParticleSet& set, ParticleStore& particles, const PairSettings& settings,
                     std::vector<double> rest_density, const Ranks& ranks);

    /// Whether pairs within solids are needed.
    [[nodiscard]] bool conducts_in_solids() const { return conducts_in_solids_; }
    /// Before copies learn of concentrations: those of owned particles from their amounts, of surfaces those at time t;
    /// and what is taken up during dt before neighbours supply anything.
    void start(ParticleStore& particles, double t, double dt);
    /// What the sweep of density rates, which is to come before advance(), sums for a species on its way, if anything.
    [[nodiscard]] std::optional<SpeciesSums> along(const PairSweeps& sweeps, double dt, const ShiftStep& shift) const;
    /// Diffusion during dt, from the concentrations of its start, of which copies know; where particles are about to be
    /// shifted, what stays behind of them; and the rest of what is taken up. `along`: what density rates were told to
    /// sum.
    void advance(ParticleStore& particles, Neighbours& neighbours, const PairSweeps& sweeps, double dt,
                 const ShiftStep& shift, const std::optional<SpeciesSums>& along);

    [[nodiscard]] std::size_t count() const { return species_.size(); }
    [[nodiscard]] const CarriedSpecies& carried(std::size_t species) const { return species_[species]; }
    /// Volume at rest of an owned particle [m^3].
    [[nodiscard]] double rest_volume(const ParticleGroup& group, std::size_t i) const;
    [[nodiscard]] double concentration(const ParticleGroup& group, std::size_t i, std::size_t species) const;
    /// What the surface of this part (of any part: none given) has taken, or, of other particles, hold. All ranks take
    /// part.
    [[nodiscard]] double taken_by_surfaces(const ParticleStore& particles, std::size_t species,
                                           std::optional<std::uint16_t> part = {}) const;
    [[nodiscard]] double held_by_particles(const ParticleStore& particles, std::size_t species) const;
    /// What this part (any part: none given) has taken up since the start. All ranks take part.
    [[nodiscard]] double taken_up(std::size_t species, std::optional<std::uint16_t> part = {}) const;
    /// Of each species, from the start to now.
    [[nodiscard]] std::vector<SpeciesBalance> balances(const ParticleStore& particles) const;

    /// None where diffusion is explicit.
    [[nodiscard]] const ViscousSolves& solves() const { return solves_; }
    void archive(Archive& file);

  private:
    void declare(const Scene& scene, ParticleStore& particles);
    void show(ParticleStore& particles, double t) const;
    [[nodiscard]] static bool stays(const CarriedSpecies& species, const ShiftStep& shift);
    [[nodiscard]] static SpeciesSums sums_of(const CarriedSpecies& species, double dt);
    static void add_shift(const ShiftStep& shift, SpeciesSums& sums);
    void hand_over(const CarriedSpecies& species, ParticleStore& particles);
    void fill(const Species& species, const ParticleSet& set, const std::vector<const Part*>& parts,
              ParticleStore& particles, CarriedSpecies& carried);
    void fill_surfaces(const Scene& scene, const Species& species, const ParticleSet& set, ParticleStore& particles,
                       CarriedSpecies& carried);
    void solve(const CarriedSpecies& species, ParticleStore& particles, Neighbours& neighbours,
               const PairSweeps& sweeps, const SpeciesSums& of_step);
    [[noreturn]] void give_up(const CarriedSpecies& species, double error, long iterations) const;
    [[nodiscard]] bool is_surface(const ParticleGroup& group, std::size_t i, std::size_t species) const;

    std::vector<Species> given_;
    std::vector<CarriedSpecies> species_;
    std::vector<SpeciesUptake> uptake_;  ///< by species
    std::vector<double> rest_density_;
    const Ranks& ranks_;
    int threads_;
    bool implicit_, conducts_in_solids_ = false;
    double tolerance_;
    bool one_density_;              ///< of all liquids
    double largest_volume_ = 0;     ///< of a particle, with room for its being stretched [m^3]
    std::vector<double> at_start_;  ///< amounts by species
    std::vector<double> excess_;    ///< by species: what shifting has made and was too little to be given back
    ViscousSolves solves_;
};

}  // namespace dmp::solver
