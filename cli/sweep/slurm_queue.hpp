// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dmp::cli {

/// An element of a job array that waits or runs.
struct QueuedElement {
    std::string job;     ///< "123"
    long element = 0;    ///< of its array
    std::string state;   ///< "PD", "R", "CG", ...
    std::string reason;  ///< why it waits: "Resources", "PartitionTimeLimit", ...
    std::string script;  ///< path of the job's script

    [[nodiscard]] bool is_waiting() const { return state == "PD"; }
};

/// What squeue prints for slurm_queue, read. Lines that are none of an array are left out.
[[nodiscard]] std::vector<QueuedElement> read_queue(const std::string& text);

/// The largest index of an array that this `scontrol show config` allows.
[[nodiscard]] std::size_t largest_element(const std::string& configuration);

/// How a job ended that left no word of its own.
struct JobState {
    std::string state;  ///< "OUT_OF_MEMORY", "CANCELLED", "TIMEOUT", "NODE_FAIL", ...; "": Slurm no longer knows it
    std::string reason;
};
/// Of what `scontrol show job` says.
[[nodiscard]] JobState read_job_state(const std::string& text);

/// Slurm, by its programs.
class SlurmQueue {
  public:
    /// Throws InputError where this machine has no sbatch, squeue and scontrol.
    SlurmQueue();
    /// None where squeue is missing.
    [[nodiscard]] static std::optional<SlurmQueue> if_there();

    /// Hands in a job; its number, or what sbatch says against it.
    struct Answer {
        std::string job, refusal;
    };
    [[nodiscard]] Answer submit(const std::filesystem::path& script) const;
    /// This user's elements that wait or run; none: squeue has no answer now, and `problem` says why.
    [[nodiscard]] std::optional<std::vector<QueuedElement>> elements(std::string& problem) const;
    [[nodiscard]] JobState state_of(const std::string& job, long element) const;
    /// Most elements of an array, counted from 1.
    [[nodiscard]] std::size_t most_elements() const;

  private:
    struct Unchecked {};
    explicit SlurmQueue(Unchecked /*without a look at what is installed*/) {}
};

}  // namespace dmp::cli
