// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/results/frame.hpp"
#include "solver/results/plan.hpp"

namespace dmp::solver {

/// Conserved quantities.
struct Conserved {
    double mass = 0;                   ///< of all moving particles [kg]
    std::array<double, 3> momentum{};  ///< of all moving particles [kg m/s]
};

/// Number of solves and iterations of implicit viscosity.
struct ViscousSolves {
    std::int64_t solves = 0, iterations = 0, most_iterations = 0;  ///< most_iterations: of one solve
    [[nodiscard]] double mean_iterations() const {
        return solves > 0 ? static_cast<double>(iterations) / static_cast<double>(solves) : 0;
    }
};

/// Balance of a species.
struct SpeciesBalance {
    std::string name, unit;     ///< unit of amounts
    double start = 0, end = 0;  ///< in all particles that carry it
    double from_walls = 0;      ///< from walls held at a concentration or with a given flux
    double taken_up = 0;        ///< by the parts' uptake
    /// The unaccounted amount, divided by the largest of start, end and what was taken up.
    [[nodiscard]] double residual() const {
        const double scale = std::max({std::abs(start), std::abs(end), taken_up});
        return scale > 0 ? (end - start - from_walls + taken_up) / scale : 0;
    }
};

/// Distribution of the work over the ranks.
struct RankShares {
    double imbalance = 1;         ///< load of the busiest rank divided by the mean, at the last list [-]
    double ghosts_per_owned = 0;  ///< ghosts, including periodic images, per particle [-]
    /// Messages and bytes per step that the rank sending most has sent for ghosts, on average.
    double messages_per_step = 0, bytes_per_step = 0;
};

/// Mechanical energy of spheres.
struct SphereEnergy {
    double translation = 0, rotation = 0;  ///< of free spheres [J]
    double contacts = 0;  ///< stored in contacts, also at walls; of adhesion, relative to bodies far apart [J]
    [[nodiscard]] double kinetic() const { return translation + rotation; }
    [[nodiscard]] double total() const { return kinetic() + contacts; }
};

/// Results of a run of spheres.
struct SphereSummary {
    SphereEnergy start, end;
    std::size_t contacts = 0;    ///< between spheres, at the end
    double largest_overlap = 0;  ///< at the end, divided by the smaller radius; including walls [-]
    double still_since = 0;      ///< [s] start of the steady state; 0: not requested, or not reached
};

/// Size of one elastic solid, or of the solid of one [[solidify]], at present, and the changes of its bonds.
struct Aggregate {
    std::string name;
    std::int64_t particles = 0;
    double mass = 0;           ///< [kg]
    std::int64_t pieces = 0;   ///< number of bodies with some of it
    std::int64_t largest = 0;  ///< largest number of its particles in one body
    std::int64_t bonds_made = 0, bonds_broken = 0;
};

/// Of the bonds of an elastic solid, in each tenth step and at the end (SpringStrain): length / rest length - 1 [-].
struct LargestStrain {
    std::string name;
    double compressed = 0, stretched = 0;  ///< the lowest, at most 0, and the highest, at least 0
    bool of_cells = false;                 ///< Green's principal strains, not those of bonds
};

/// One of several closed chambers of the fluid, each of which keeps its volume.
struct ChamberDrift {
    double mass = 0;                ///< of its liquid [kg]
    double drift = 0;               ///< by how much its mean density would have drifted, which was taken off [-]
    std::array<double, 3> place{};  ///< of one of its particles [m]
};

/// How deep surfaces have passed into each other at most.
struct ContactSummary {
    double depth = 0;               ///< [m]
    double time = 0;                ///< [s]
    std::array<double, 3> place{};  ///< [m]
};

struct RunSummary {
    std::map<std::string, std::size_t> particles;
    long steps = 0;
    double simulated_s = 0;
    double wall_s = 0;
    /// Of all threads of all ranks in the steps; of a run that went on, as if all had cost what those since then did.
    double processor_s = 0;
    double particle_steps_per_s = 0;
    int threads = 1;
    int ranks = 1;
    std::vector<StepLimit> limits;
    std::string ruling_limit;
    double sound_speed = 0;    ///< [m/s]
    double largest_speed = 0;  ///< that the fluid reached [m/s]
    /// From one particle to the next, of itself (VelocityChange) [-]; nothing with the plain scheme.
    std::optional<double> velocity_change;
    std::vector<LargestStrain> strains;     ///< of elastic solids
    std::optional<ContactSummary> contact;  ///< of surfaces; none if nothing touched
    /// Where the flow that was reached is not the one that was planned.
    std::vector<Warning> warnings;
    Conserved start, end;
    std::array<double, 3> impulse_of_body_forces{};  ///< given to moving particles [N s]
    std::array<double, 3> impulse_of_fixed{};        ///< given to moving particles by walls and anchors [N s]
    std::array<double, 3> impulse_of_drag{};         ///< given to moving particles by lab-frame drag [N s]
    double momentum_residual = 0;  ///< end - start - impulses| divided by the sum of the impulses' magnitudes [-]
    /// Extremes of density / rest density over the whole run, times the first fluid's rest density [kg/m^3].
    double density_low = 0, density_high = 0;
    /// By how much the mean of the densities would have drifted, which keeping the fluid's volume took off [-].
    double density_drift = 0;
    std::vector<ChamberDrift> chambers;  ///< where there are several at the end
    std::size_t lost = 0;
    std::string state_hash;  ///< of all particles, their final positions, velocities and densities, 16 hex digits
    std::map<std::string, double> seconds_by_stage;
    MeasureSeries measures;
    std::string_view vector_unit;  ///< of the loops over pairs
    RankShares shares;
    std::optional<SphereSummary> spheres;
    ViscousSolves viscous_solves;  ///< none if viscosity is explicit
    std::vector<SpeciesBalance> species;
    ViscousSolves species_solves;       ///< none if diffusion is explicit
    std::vector<Aggregate> aggregates;  ///< of bodies that may change
    long first_step = 0;                ///< of this process; 0 unless it resumed
    bool interrupted = false;           ///< stopped before its end
    bool out_of_time = false;           ///< stopped at the wall-time limit
};

}  // namespace dmp::solver
