// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/parallel/resources.hpp"
#include "solver/results/plan.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/time/run.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The interface of the solver: a scene's particles in motion.
class Simulation {
  public:
    /// Throws InputError when scene and particles do not fit together, ResourceError when the machine lacks what is
    /// asked of it.
    Simulation(const Scene& scene, const ParticleSet& particles, const Resources& resources = {});

    /// What a run will be: models, step limits, memory.
    [[nodiscard]] Plan plan() const { return run_->plan(); }

    /// Restores the state of a checkpoint of the same scene; on any number of ranks and threads. Throws InputError when
    /// it does not fit. Returns the number of frames that were written by then.
    long resume(const std::filesystem::path& checkpoint);

    /// Takes over the state of a checkpoint of another run of the same particles, with its time; values that
    /// scene::fixed_in_start leaves free may be others. Counts, sums, frames and measures begin anew. On any number of
    /// ranks and threads. Throws InputError when the state does not fit.
    void start_from(const std::filesystem::path& checkpoint);

    /// Runs to the end. Throws DivergenceError (after writing a last frame to the sink) and ResourceError.
    RunSummary run(const RunOptions& options) { return run_->run(options); }

  private:
    std::unique_ptr<Run> run_;
};

}  // namespace dmp::solver
