// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dmp::solver {

/// A checkpoint that a run can go on from.
struct FoundCheckpoint {
    std::filesystem::path file;
    long step = 0;
    std::vector<std::string> messages;  ///< one for each newer checkpoint that is not whole, newest first
};

/// The checkpoints of one run: OUT/checkpoints/step_000001234.h5. What else is in the folder is left alone.
class CheckpointFolder {
  public:
    /// `out` is the run's folder. Makes nothing.
    explicit CheckpointFolder(const std::filesystem::path& out) : folder_(out / "checkpoints") {}

    /// Throws InputError when the folder cannot be made or written to.
    void make() const;

    [[nodiscard]] std::filesystem::path path_for(long step) const;

    /// The newest checkpoint that passes check_seal; none when there are none at all.
    /// Throws InputError when there are some and all are bad.
    [[nodiscard]] std::optional<FoundCheckpoint> newest_good();

    /// To be called when the checkpoint of `written` is finished: that one and the newest good one before it stay. All
    /// others go, those of later steps too (what a run that went on from an earlier step left behind it), and files
    /// that were never finished. Throws ResourceError when one cannot be removed.
    void keep_last_two(long written);

    /// Removes all checkpoints, those never finished too, and the folder if that leaves it empty. Returns how many
    /// files went. Throws ResourceError when one cannot be removed.
    std::size_t remove();

  private:
    /// What is wrong with it, "" if nothing; a good one is read once only.
    [[nodiscard]] std::string problem_with(long step, const std::filesystem::path& file);

    std::filesystem::path folder_;
    std::set<long> good_;  ///< steps whose files were checked, or written, by this object's owner
};

}  // namespace dmp::solver
