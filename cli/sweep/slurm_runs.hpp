// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/wall_clock.hpp"
#include "cli/progress.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/slurm_folder.hpp"
#include "cli/sweep/slurm_job.hpp"
#include "cli/sweep/slurm_queue.hpp"
#include "cli/sweep/sweep_progress.hpp"
#include "cli/sweep/sweep_rows.hpp"

namespace dmp::cli {

/// How a study's jobs are made.
struct SlurmSettings {
    std::string program;                   ///< path of this dmp, as the nodes see it
    std::string study;                     ///< the study's file, as given
    std::vector<std::string> overrides{};  ///< of the scene in all runs, as given
    std::filesystem::path out;             ///< its folder, as given
    study::Slurm slurm;                    ///< with what the command line says; threads are given
    int at_a_time = 0;                     ///< most elements of an array that run at a time; 0: no limit
    std::string form = job_form();         ///< of the job script
};

/// The job of these runs, as it would be handed in.
[[nodiscard]] SlurmJob job_of(const SlurmSettings& settings, const std::string& study,
                              const std::filesystem::path& folder, std::size_t elements);

/// Does the runs of a study in jobs of Slurm, and collects what comes back: hands in what is neither done nor in the
/// queue, and waits. The jobs do without this process: it may end at any time and another one take its place.
class SlurmRuns {
  public:
    SlurmRuns(SweepRows& rows, SlurmQueue queue, SlurmSettings settings);

    /// Until the last run has ended, or a signal asks to stop: then the jobs stay in the queue. Throws InputError where
    /// sbatch refuses the first job, ResourceError where a table cannot be written.
    void run(const StopSignals& signals);

    /// What there is to do about jobs that are still in the queue; "": there are none.
    [[nodiscard]] std::string left_text() const;

  private:
    /// Runs that ended while nobody collected, and those that are in the queue; the others wait to be handed in.
    void take_earlier();
    void submit_some();
    /// False: sbatch takes no more now. Throws InputError where it is the only one.
    bool submit(const std::vector<std::vector<std::string>>& elements);
    /// Takes the ends that jobs have left.
    void take_ends();
    /// Notes the times of ends that the table has, and removes them.
    void remove_ends(const std::vector<std::string>& runs);
    /// Every few seconds.
    void look_at_queue();
    /// Whether the job of a run is gone, which has left no end, or one of a run that was asked to stop: then that is
    /// its row.
    bool is_lost(const std::string& run);
    void add(std::size_t index, SweepRow row);
    void say(const std::string& text);
    void tell_once(const std::string& text);
    void show_progress();

    SweepRows& rows_;
    SlurmQueue queue_;
    SlurmSettings settings_;
    SlurmFolder folder_;
    std::vector<SubmittedJob> jobs_;
    std::map<std::string, std::size_t> pending_;  ///< runs in the queue, by name: their indices
    std::deque<std::size_t> unsubmitted_;
    std::map<std::string, QueuedElement> queued_;  ///< as squeue had them last
    std::map<std::string, int> missing_;           ///< how often squeue has not had a pending run
    std::set<std::string> told_;
    std::size_t most_elements_ = 0;  ///< of an array; 0: not asked for yet
    std::size_t refused_with_ =
        std::numeric_limits<std::size_t>::max();  ///< runs in the queue when sbatch refused more
    WallClock::time_point looked_ = WallClock::now();
    double look_after_s_ = 0;  ///< at the queue [s]
    ProgressLine line_;
    LineEvery lines_;
    WallClock::time_point started_ = WallClock::now();
};

}  // namespace dmp::cli
