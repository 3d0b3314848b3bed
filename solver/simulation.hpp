// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/frame.hpp"
#include "solver/resources.hpp"
#include "solver/sound_speed.hpp"
#include "solver/state/checkpoints.hpp"
#include "solver/uses.hpp"
#include "solver/warnings.hpp"

namespace dmp::solver {

/// The largest stable step of one model.
struct StepLimit {
    std::string model;    ///< "sound", "viscosity", "body force", "contact", "springs (leaflets)"
    double dt = 0;        ///< [s]
    std::string formula;  ///< how it comes about
};

/// A model the scene makes run, and why.
struct ModelUse {
    std::string model;                  ///< "Tait equation of state", "Morris viscosity", ...
    std::string source;                 ///< equation and paper
    std::string reason;                 ///< the scene's line that asks for it, or "default"
    std::vector<std::string> fields{};  ///< per-particle arrays that are there for it
    std::size_t bytes = 0;              ///< of them, for one particle of each kind that has them
};

/// What a run will be, before it runs.
struct Plan {
    std::map<std::string, std::size_t> particles;  ///< by kind
    std::size_t bytes_per_particle = 0;
    double sound_speed = 0;    ///< c0 [m/s]
    SoundSpeed sound;          ///< the same, and why
    double largest_speed = 0;  ///< expected [m/s]
    double dt = 0;             ///< fluid step [s]
    int spring_substeps = 0;   ///< spring steps in one fluid step; 0: no springs
    long steps = 0;
    std::vector<StepLimit> limits;  ///< of the fluid step and the spring step
    std::string ruling_limit;       ///< which of them sets the fluid step
    std::vector<ModelUse> models;
    std::vector<std::string> fields;         ///< per-particle arrays that are allocated, with their bytes
    std::vector<std::string> common_fields;  ///< those of them that no model alone asked for
    std::vector<Warning> warnings;
};

/// Momentum and mass, and what came and went.
struct Conserved {
    double mass = 0;                   ///< of all moving particles [kg]
    std::array<double, 3> momentum{};  ///< of all moving particles [kg m/s]
};

/// How much work implicit viscosity has been.
struct ViscousSolves {
    std::int64_t solves = 0, iterations = 0, most_iterations = 0;  ///< the last: of one solve
    [[nodiscard]] double mean_iterations() const {
        return solves > 0 ? static_cast<double>(iterations) / static_cast<double>(solves) : 0;
    }
};

/// Where a species has come from and gone.
struct SpeciesBalance {
    std::string name, unit;     ///< of amounts
    double start = 0, end = 0;  ///< in all particles that carry it
    double from_walls = 0;      ///< given off by walls that are held at a concentration or give off a flux
    /// What is unaccounted for, over the larger of what was there.
    [[nodiscard]] double residual() const {
        const double scale = std::max(std::abs(start), std::abs(end));
        return scale > 0 ? (end - start - from_walls) / scale : 0;
    }
};

/// How the ranks shared the work.
struct RankShares {
    double imbalance = 1;         ///< the busiest rank's load over the mean, at the last list [-]
    double copies_per_owned = 0;  ///< copies of particles, periodic images included, for each particle [-]
    /// What the rank that sends most has sent to others for copies in a step, on average.
    double messages_per_step = 0, bytes_per_step = 0;
};

/// Mechanical energy of spheres.
struct SphereEnergy {
    double translation = 0, rotation = 0;  ///< of free spheres [J]
    [[nodiscard]] double kinetic() const { return translation + rotation; }
};

/// How a run of spheres went.
struct SphereSummary {
    SphereEnergy start, end;
    std::size_t contacts = 0;    ///< of spheres that touch each other, at the end
    double largest_overlap = 0;  ///< at the end, over the smaller radius; with walls too [-]
    double still_since = 0;      ///< [s]; when nothing changed any more; 0: that was not asked for, or did not come
};

/// How large the solid of one springs part or [[solidify]] is now, and what has happened to its bonds.
struct Aggregate {
    std::string name;
    std::int64_t particles = 0;
    double mass = 0;           ///< [kg]
    std::int64_t pieces = 0;   ///< bodies that hold some of it
    std::int64_t largest = 0;  ///< most of its particles in one body
    std::int64_t bonds_made = 0, bonds_broken = 0;
};

struct RunSummary {
    std::map<std::string, std::size_t> particles;
    long steps = 0;
    double simulated_s = 0;
    double wall_s = 0;
    double particle_steps_per_s = 0;
    int threads = 1;
    int ranks = 1;
    std::vector<StepLimit> limits;
    std::string ruling_limit;
    double sound_speed = 0;
    Conserved start, end;
    std::array<double, 3> impulse_of_body_forces{};  ///< given to moving particles [N s]
    std::array<double, 3> impulse_of_fixed{};        ///< given to moving particles by walls and anchors [N s]
    std::array<double, 3> impulse_of_drag{};         ///< given to moving particles by lab-frame drag [N s]
    double momentum_residual = 0;  ///< |end - start - impulses| over the sum of the impulses' magnitudes [-]
    /// Extremes over the whole run of density over rest density, times the first fluid's rest density [kg/m^3].
    double density_low = 0, density_high = 0;
    std::size_t lost = 0;
    std::string state_hash;  ///< of all particles, their final positions, velocities and densities, 16 hex digits
    std::map<std::string, double> seconds_by_stage;
    MeasureSeries measures;
    std::string_view vector_unit;  ///< of the loops over pairs
    RankShares shares;
    std::optional<SphereSummary> spheres;
    ViscousSolves viscous_solves;  ///< none where viscosity is explicit
    std::vector<SpeciesBalance> species;
    ViscousSolves species_solves;       ///< none where diffusion is explicit
    std::vector<Aggregate> aggregates;  ///< where bodies may change
    long first_step = 0;                ///< that this process made; 0 unless it resumed
    bool interrupted = false;           ///< left before its end
    bool out_of_time = false;           ///< by the wall time's limit
};

struct RunProgress {
    double time = 0, until = 0;  ///< [s]
    long step = 0;
    double dt = 0;
    double largest_speed = 0;
    long frames = 0;
};

struct RunOptions {
    double until = 0;  ///< [s]; 0 = the scene's duration
    FrameSink* sink = nullptr;
    std::function<void(const RunProgress&)> progress;  ///< called a few times a second at most
    const std::atomic<bool>* stop = nullptr;           ///< set from a signal handler: finish the step, write, leave
    double wall_limit = 0;                             ///< wall time after which to write and leave [s]; 0: none
    CheckpointOptions checkpoints;
};

class SphereRun;

/// A scene's particles in motion.
class Simulation {
  public:
    /// Throws InputError when scene and particles do not fit together, ResourceError when the machine lacks what is
    /// asked of it.
    Simulation(const Scene& scene, const ParticleSet& particles, const Resources& resources = {});
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    [[nodiscard]] Plan plan() const;

    /// Takes up the state of a checkpoint of the same scene; on any number of ranks and threads. Throws InputError when
    /// it does not fit. Returns the number of frames that were written by then.
    long resume(const std::filesystem::path& checkpoint);

    /// Runs to the end. Throws DivergenceError (after writing a snapshot to the sink) and ResourceError.
    RunSummary run(const RunOptions& options);

  private:
    struct State;
    std::unique_ptr<State> state_;        ///< fluid and springs
    std::unique_ptr<SphereRun> spheres_;  ///< or spheres
};

}  // namespace dmp::solver
