// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "base/wall_clock.hpp"
#include "cli/progress.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/run_starter.hpp"
#include "cli/sweep/sweep_memory.hpp"
#include "cli/sweep/sweep_progress.hpp"
#include "cli/sweep/sweep_rows.hpp"
#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/run_output.hpp"

namespace dmp::cli {

/// How a study's runs are started.
struct SweepSettings {
    std::string program;      ///< the name they are called by
    int jobs = 1;             ///< runs at a time
    int threads = 1;          ///< of each
    study::LeftOut left_out;  ///< what they do not write
    /// Whether a run may be started now; one that may not is asked for again when another has ended. Empty: all may.
    std::function<bool(std::size_t index)> may_start{};
    /// Then those that still run are stopped, and go on from their checkpoints another time.
    WallClock::time_point stop_at = WallClock::time_point::max();
};

/// Does the chosen runs of a study, several at a time, each in a process of its own. Those that are finished in the
/// folder are not run again; those that were begun go on from their checkpoints, or from the start where they have
/// none. What still runs at the end of this object is stopped, and waited for.
class SweepRuns {
  public:
    SweepRuns(SweepRows& rows, SweepSettings settings);
    SweepRuns(const SweepRuns&) = delete;
    SweepRuns& operator=(const SweepRuns&) = delete;

    /// Until the last one has ended, it is time to stop, or a signal asks for it: then the runs get SIGTERM, and write
    /// their checkpoints. Throws InputError where the scene's file is changed meanwhile, ResourceError where a table
    /// cannot be written; the runs are stopped then, too.
    void run(const StopSignals& signals);

  private:
    struct Running {
        std::size_t index;
        study::Point point;
        WallClock::time_point start;
    };

    [[nodiscard]] bool is_to_stop(const StopSignals& signals) const;
    /// Starts what there is room for; what another process still writes is put off.
    void start_some(const StopSignals& signals);
    void start(std::size_t index, study::Point point);
    /// Tries the first run out, which may take long: its particles are made. Throws ResourceError where it takes more
    /// memory than the machine has.
    void learn_memory(const StopSignals& signals);
    /// Whether there is memory for one more run; says once that there is none.
    [[nodiscard]] bool has_room(const study::Point& point);
    /// Whether another process writes into this run's folder; says so once.
    [[nodiscard]] bool is_held(std::size_t index, const std::filesystem::path& run);
    /// Throws InputError where the scene has other values than those that the study began with.
    void check_scene();
    void collect(bool stopping);
    void take_end(const Running& running, const RunEnd& end, bool stopping);
    /// Runs whose end nobody has seen are gone on with later.
    void put_off_lost(const std::vector<RunEnd>& ends);
    void add(std::size_t index, SweepRow row);
    void say(const std::string& line);
    void show_progress();

    SweepRows& rows_;
    const study::Study& study_;
    const study::Points& points_;
    const SweepFolder& folder_;
    SweepSettings settings_;
    std::string scene_text_;
    std::deque<std::size_t> waiting_;
    std::vector<std::size_t> refused_;  ///< by may_start, since a run has ended
    std::vector<std::size_t> put_off_;  ///< another process has their folders
    std::set<std::size_t> told_held_;   ///< of which it was said that they wait for another process
    std::list<Running> running_;
    RunStarter starter_;
    SweepMemory memory_;
    bool told_memory_ = false;
    int losses_ = 0;  ///< of all that ran, since a run has ended
    WallClock::time_point started_ = WallClock::now();
    std::size_t ended_ = 0;  ///< processes that have ended
    double ended_s_ = 0;     ///< the wall time that they took together [s]
    ProgressLine line_;
    LineEvery lines_;
};

}  // namespace dmp::cli
