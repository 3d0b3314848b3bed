// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dmp::solver {

/// Where a run took the state from that it started with.
struct StartedFrom {
    std::string checkpoint;  ///< the file, as it was called
    std::int64_t step = 0;
    double time = 0;  ///< [s]
};

/// What a checkpoint says of its run besides the state; "": nothing.
struct CheckpointLabel {
    std::string scene;        ///< resolved, for comparison
    std::string dmp_version;  ///< of the dmp that wrote it
    std::string particles;    ///< their fingerprint (particles/fingerprint.hpp)
    std::optional<StartedFrom> started_from;
};

/// A checkpoint from which a run can resume.
struct FoundCheckpoint {
    std::filesystem::path file;
    long step = 0;
    double time = 0;                    ///< [s]; checkpoint_to_resume finds it
    std::vector<std::string> messages;  ///< one for each newer checkpoint that is unusable, newest first
    CheckpointLabel label{};            ///< checkpoint_to_resume finds it
};

/// The checkpoints of one run: OUT/checkpoints/step_000001234.h5. Other files in the folder are left alone.
class CheckpointFolder {
  public:
    /// `out` is the run's folder. Creates nothing.
    explicit CheckpointFolder(const std::filesystem::path& out) : folder_(out / "checkpoints") {}

    /// Throws InputError if the folder cannot be created or written to.
    void make() const;

    [[nodiscard]] std::filesystem::path path_for(long step) const;

    /// All checkpoints that pass check_seal, newest first; each with a message for every newer one that does not.
    [[nodiscard]] std::vector<FoundCheckpoint> all_good();

    /// The newest checkpoint that passes check_seal; nothing if there are no checkpoints.
    /// Throws InputError if there are some and all are bad.
    [[nodiscard]] std::optional<FoundCheckpoint> newest_good();

    /// Must be called when the checkpoint of step `written` is finished. Keeps it and the newest good one before it.
    /// Removes all others, including those of later steps (left over when a run was resumed from an earlier step) and
    /// unfinished files. Throws ResourceError if a file cannot be removed.
    void keep_last_two(long written);

    /// Removes all checkpoints, including unfinished ones, and the folder if it is then empty. Returns the number of
    /// removed files. Throws ResourceError if one cannot be removed.
    std::size_t remove();

  private:
    /// Describes what is wrong with the file, "" if nothing; a good file is read only once.
    [[nodiscard]] std::string problem_with(long step, const std::filesystem::path& file);

    std::filesystem::path folder_;
    std::set<long> good_;  ///< steps whose files this object has checked or its owner has written
};

}  // namespace dmp::solver
