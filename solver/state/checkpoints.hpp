// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "solver/state/archive.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::solver {

/// Checkpoint settings of a run.
struct CheckpointOptions {
    std::filesystem::path folder;  ///< of the run; checkpoints are in a subfolder. Empty: none are written
    double every = 600;            ///< wall time between checkpoints [s]; 0: only when the run is stopped
    bool at_end = true;            ///< one also of a run that reaches its end, which can then be made longer
    CheckpointLabel label;         ///< stored in each
};

/// Writes the checkpoints of a run and keeps the last two. Rank 0 writes the files.
class Checkpoints {
  public:
    using ArchiveAll = std::function<void(Archive&)>;

    Checkpoints(const Ranks& ranks, CheckpointOptions options);

    [[nodiscard]] bool wanted() const { return !options_.folder.empty(); }
    /// True if it is time for a checkpoint, by this rank's clock.
    [[nodiscard]] bool due() const;
    /// Throws ResourceError, on all ranks, if the file cannot be written.
    void save(long step, const ArchiveAll& archive_all);

  private:
    using Clock = std::chrono::steady_clock;

    const Ranks& ranks_;
    CheckpointOptions options_;
    CheckpointFolder folder_;
    Clock::time_point last_ = Clock::now();
};

/// The checkpoint of the run in `folder` with whose state another run that ends at `until` [s] can start: that of the
/// time `at` [s], or the last one before it; the last of all where no time is asked for. Called by one process. Throws
/// InputError if there is none, with the times that there are, or if it is not before `until`.
FoundCheckpoint checkpoint_to_start_from(const std::filesystem::path& folder, std::optional<double> at, double until);

/// Finds the checkpoint from which a run in `folder` can resume, for a scene with this resolved text (what does not
/// change the state may differ: differences_in_state) that is to end at `until` [s]. Called by one process. Throws
/// InputError if there is no checkpoint, if all are unusable, if the run has got to `until` already, or if it belongs
/// to another scene, with the lines that differ.
FoundCheckpoint checkpoint_to_resume(const std::filesystem::path& folder, const std::string& scene, double until);

}  // namespace dmp::solver
