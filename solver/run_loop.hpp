// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "solver/parallel/ranks.hpp"
#include "solver/simulation.hpp"
#include "solver/state/checkpoints.hpp"

namespace dmp::solver {

/// How a run came to its end.
struct RunEnd {
    bool interrupted = false;  ///< before its end, by whoever or the wall time's limit
    bool out_of_time = false;
    double wall = 0;  ///< [s]
};

/// What a run consists of, whatever moves in it.
class Steps {
  public:
    virtual ~Steps() = default;
    [[nodiscard]] virtual double time() const = 0;
    [[nodiscard]] virtual std::int64_t step() const = 0;
    /// One step, towards `until` or the next time at which something is due.
    virtual void advance(const RunOptions& options, double until) = 0;
    virtual void write_frame(FrameSink* sink) = 0;
    virtual void archive(Archive& file) = 0;
    [[nodiscard]] virtual RunProgress progress(double until) const = 0;
    /// Whether there is nothing more to come; the same on all ranks.
    [[nodiscard]] virtual bool finished() const { return false; }
};

/// Makes steps until `until`; saves checkpoints, tells of progress, and leaves early when asked to. A time that the
/// options ask for gets a frame, also where none is due. All ranks together.
RunEnd run_steps(Steps& steps, const Ranks& ranks, Checkpoints& checkpoints, const RunOptions& options, double until);

}  // namespace dmp::solver
