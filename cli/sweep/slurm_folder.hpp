// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/sweep/slurm_queue.hpp"

namespace dmp::cli {

/// How a run ended that a job had started.
struct JobEnd {
    int exit_code = 0;
    double wall_s = 0, processor_s = 0;  ///< [s]
    double peak_memory = 0;              ///< [bytes]
    std::string job;                     ///< "123_4"; "": no job of Slurm
    long checkpoint = -1;                ///< step of the newest one that it left; -1: none
    std::string error;                   ///< as results.csv has it

    /// Whether the run goes on from there when its job is started again: it was asked to stop.
    [[nodiscard]] bool is_unfinished() const;
};

/// Whether a run that ends with this code was stopped by a signal that asks for a checkpoint.
[[nodiscard]] bool is_stopped(int exit_code);

/// A job that was handed in, as its folder slurm/N has it.
struct SubmittedJob {
    std::filesystem::path folder;
    std::string job;                                 ///< its number; "": the sweep was killed before it knew it
    std::vector<std::vector<std::string>> elements;  ///< names of the runs that each does; the first element is 1

    /// Whether an element of the queue is one of this job's.
    [[nodiscard]] bool has(const QueuedElement& element) const;
};

/// What jobs leave in the folder of a study, below slurm/. Jobs add ends, one job a run at a time; the sweep does all
/// else.
class SlurmFolder {
  public:
    /// `folder`: of the study.
    explicit SlurmFolder(const std::filesystem::path& folder) : folder_(folder / "slurm") {}

    /// All that were handed in, in order.
    [[nodiscard]] std::vector<SubmittedJob> jobs() const;
    /// A new folder for a job, with the file that names the runs of its elements.
    [[nodiscard]] std::filesystem::path add_job(const std::vector<std::vector<std::string>>& elements) const;
    /// Notes the number that a job was given.
    static void note_number(const std::filesystem::path& job_folder, const std::string& number);

    /// Of one that was not handed in.
    static void remove_job(const std::filesystem::path& job_folder);

    /// The last thing that an element, or Slurm of it, has said; "": nothing.
    [[nodiscard]] static std::string last_words(const SubmittedJob& job, long element);

    /// How a run ended each time since the sweep has last taken its ends; the last one last.
    [[nodiscard]] std::vector<JobEnd> ends_of(const std::string& run) const;
    /// Names of the runs that have such ends.
    [[nodiscard]] std::vector<std::string> ended_runs() const;
    void add_end(const std::string& run, const JobEnd& end) const;
    void remove_ends(const std::string& run) const;

    /// Removes what jobs and sweeps have left; others' files stay.
    void remove() const;

  private:
    [[nodiscard]] std::filesystem::path ends_file(const std::string& run) const;

    std::filesystem::path folder_;
};

/// The runs that wait or are done now in jobs of the study, by name.
[[nodiscard]] std::map<std::string, QueuedElement> queued_runs(const std::vector<SubmittedJob>& jobs,
                                                               const std::vector<QueuedElement>& queue);

}  // namespace dmp::cli
