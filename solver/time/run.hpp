// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "solver/parallel/ranks.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/plan.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/state/checkpoints.hpp"

namespace dmp::solver {

struct RunProgress {
    double time = 0, until = 0;  ///< [s]
    long step = 0;
    double dt = 0;
    double largest_speed = 0;
    long frames = 0;
    double density_low = 0, density_high = 0;  ///< of the fluid over its rest density [-]; 0: there is none
};

struct RunOptions {
    double until = 0;  ///< [s]; 0 = the scene's duration. A later end only adds to the run: see Run::run
    FrameSink* sink = nullptr;
    std::function<void(const RunProgress&)> progress;  ///< called a few times a second at most
    /// Called as soon as the run leaves what it was planned for, at a time [s].
    std::function<void(double, const Warning&)> warn;
    /// Called with all that has been measured, at the start and after each new row.
    std::function<void(const MeasureSeries&)> measured;
    const std::atomic<bool>* stop = nullptr;  ///< set from a signal handler: finish the step, write, leave
    double wall_limit = 0;  ///< wall time after which to write and leave, after a step at least [s]; 0: none
    CheckpointOptions checkpoints;
};

/// A scene in motion, whatever moves in it: a fluid with elastic solids (FluidRun) or spheres (SphereRun).
class Run {
  public:
    Run() = default;
    virtual ~Run() = default;
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    [[nodiscard]] virtual Plan plan() const = 0;

    /// Restores the state of a checkpoint. Returns the number of frames written up to then.
    long resume(const Hdf5Reader& checkpoint);
    /// Takes over the state of a checkpoint of another run, with its time, as the state to start from.
    void start_from(const Hdf5Reader& checkpoint);

    /// Steps to the end of the run: saves checkpoints, reports progress, and stops early when asked to. All ranks
    /// together. Throws DivergenceError (after a last frame) and ResourceError.
    ///
    /// The last checkpoint is of the last state that does not depend on when the run ends, at most two steps before its
    /// end: what goes on from there, to a later end, is to the last bit the run that had that end from its start.
    RunSummary run(const RunOptions& options);

  protected:
    /// A step of length `dt` towards the time `target` [s].
    struct Step {
        double dt = 0, target = 0;
        /// The time after it: the target itself where that is as near as rounding comes.
        [[nodiscard]] double end(double time) const { return target - time <= 1.5 * dt ? target : time + dt; }
    };

    [[nodiscard]] virtual const Ranks& ranks() const = 0;
    [[nodiscard]] virtual double time() const = 0;      ///< [s]
    [[nodiscard]] virtual double duration() const = 0;  ///< of the scene [s]
    [[nodiscard]] virtual std::int64_t step() const = 0;
    [[nodiscard]] virtual long frames() const = 0;

    /// Neighbour lists and forces of the present state; at the start of a run also the first frame and measures.
    virtual void start(FrameSink* sink) = 0;
    /// The step to take towards the next time at which output is due or something changes, whenever the run ends.
    [[nodiscard]] virtual Step next_step(const RunOptions& options) = 0;
    virtual void advance(const RunOptions& options, const Step& step) = 0;
    /// After the last step.
    virtual void finish(FrameSink* sink) = 0;
    /// Whether nothing more will happen; the same on all ranks.
    [[nodiscard]] virtual bool finished() const { return false; }
    virtual void write_frame(FrameSink* sink) = 0;
    /// Adds a row of measures of the present state.
    virtual void take_measures() = 0;
    /// The same of a state that may hold anything: no neighbours are searched.
    virtual void write_diverged_frame(FrameSink* sink) = 0;
    virtual void archive(Archive& file) = 0;
    /// Whether this object's first state is that of another run.
    [[nodiscard]] bool starts_from_state() const { return starts_from_state_; }
    [[nodiscard]] virtual RunProgress progress(double until) const = 0;
    [[nodiscard]] virtual const MeasureSeries& series() const = 0;
    /// Without limits, wall time and shares, which run() adds.
    [[nodiscard]] virtual RunSummary summary() const = 0;
    /// Over this many steps.
    [[nodiscard]] virtual RankShares shares(std::int64_t steps) const = 0;

    /// Ends the run with a last frame where any rank found a violation: "problem\nwhat to do", empty where there is
    /// none. The message is that of the lowest rank with one. All ranks take part.
    void stop_on_violation(FrameSink* sink, const std::string& found);
    [[noreturn]] void diverged(FrameSink* sink, const std::string& problem, const std::string& what_to_do);

  private:
    void load(const Hdf5Reader& checkpoint, LoadedFor purpose);

    struct End {
        bool interrupted = false, out_of_time = false;
        double wall = 0;  ///< [s]
    };
    [[nodiscard]] End step_until(Checkpoints& checkpoints, const RunOptions& options, double until);
    [[nodiscard]] bool is_shaped_by_end(const Step& step, double until) const;
    [[nodiscard]] Step towards_end(const Step& step, double until) const;

    bool starts_from_state_ = false;
};

}  // namespace dmp::solver
