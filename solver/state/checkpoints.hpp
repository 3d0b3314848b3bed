// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "solver/state/archive.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::solver {

/// What a run does about checkpoints.
struct CheckpointOptions {
    std::filesystem::path folder;  ///< the run's; checkpoints lie in a folder below it. Empty: none are written
    double every = 600;            ///< wall time between two of them [s]; 0: only when the run is stopped
    std::string scene;             ///< resolved text of the scene, kept in each for comparison
};

/// Writes the checkpoints of a run; the first rank holds the pen. The last two stay.
class Checkpoints {
  public:
    using ArchiveAll = std::function<void(Archive&)>;

    Checkpoints(const Ranks& ranks, CheckpointOptions options);

    [[nodiscard]] bool wanted() const { return !options_.folder.empty(); }
    /// By this rank's clock.
    [[nodiscard]] bool due() const;
    /// Throws ResourceError, on all ranks, when the disk does not take it.
    void save(long step, const ArchiveAll& archive_all);

  private:
    using Clock = std::chrono::steady_clock;

    const Ranks& ranks_;
    CheckpointOptions options_;
    CheckpointFolder folder_;
    Clock::time_point last_ = Clock::now();
};

/// Where a run in `folder` can go on, for a scene of this resolved text (how many threads it asks for may differ). One
/// process asks. Throws InputError when there is no checkpoint, none that is whole, or it is of another scene: with the
/// lines that differ.
FoundCheckpoint checkpoint_to_resume(const std::filesystem::path& folder, const std::string& scene);

}  // namespace dmp::solver
