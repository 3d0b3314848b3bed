// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run_loop.hpp"

#include <array>

namespace dmp::solver {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

RunEnd run_steps(Steps& steps, const Ranks& ranks, Checkpoints& checkpoints, const RunOptions& options, double until) {
    const auto save = [&] { checkpoints.save(steps.step(), [&](Archive& file) { steps.archive(file); }); };
    const auto start = Clock::now();
    auto last_progress = start;
    RunEnd end;
    const double last = until * (1 - 1e-12);
    while (steps.time() < last && !steps.finished()) {
        // Whatever one rank wants, all do.
        std::array<double, 3> wishes{options.stop != nullptr && *options.stop ? 1.0 : 0.0,
                                     options.wall_limit > 0 && seconds_since(start) > options.wall_limit ? 1.0 : 0.0,
                                     checkpoints.due() ? 1.0 : 0.0};
        ranks.largest(wishes);
        end.out_of_time = wishes[1] > 0;
        end.interrupted = wishes[0] > 0 || end.out_of_time;
        if (end.interrupted) {
            if (checkpoints.wanted()) save();
            steps.write_frame(options.sink);
            break;
        }
        if (wishes[2] > 0) save();
        steps.advance(options, until);
        if (options.progress && ranks.is_first() && seconds_since(last_progress) > 0.2) {
            last_progress = Clock::now();
            options.progress(steps.progress(until));
        }
    }
    // Who asked for a time wants to see it, between frames too.
    if (options.until > 0 && !end.interrupted) steps.write_frame(options.sink);
    end.wall = seconds_since(start);
    return end;
}

}  // namespace dmp::solver
