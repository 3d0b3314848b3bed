// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "base/errors.hpp"
#include "cli/locked_folder.hpp"
#include "cli/output_folder.hpp"
#include "cli/typed_command.hpp"

namespace dmp::cli {

/// A run that is about to write into a folder.
struct NewRun {
    std::string scene;  ///< resolved
    double until = 0;   ///< [s]
    bool resume = false, overwrite = false;
};

/// The error for a folder of results that a run may not write into, and what to do, as lines to paste; `typed` is the
/// command that asked for it.
[[nodiscard]] InputError refusal(const std::filesystem::path& folder, const FolderContents& contents, const NewRun& run,
                                 const TypedCommand& typed);

/// The folder of a run, a mesh or a conversion, locked while this object lives. Nothing in it is removed by taking it.
class ResultsFolder {
  public:
    /// For a run. Throws InputError if the folder cannot be made or written to, another process writes there, it holds
    /// results that the command line does not say what to do with, or a finished run that is to go on has got to the
    /// end of this one already.
    ResultsFolder(const std::filesystem::path& folder, const NewRun& run, const TypedCommand& typed);
    /// For 'dmp mesh', which replaces an earlier mesh and no run. Throws likewise.
    ResultsFolder(const std::filesystem::path& folder, const TypedCommand& typed);
    /// For 'dmp convert', which adds to what a run left in a folder that is there. Throws likewise.
    [[nodiscard]] static ResultsFolder of_run(const std::filesystem::path& folder);

    [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
    /// What to tell of a process that ended without removing its lock; "" if there was none.
    [[nodiscard]] const std::string& note() const { return folder_.note(); }
    /// Throws ResourceError if another process has taken the folder.
    void check() const { folder_.check(); }

  private:
    ResultsFolder(const std::filesystem::path& folder, const std::string& instead) : folder_(folder, instead) {}

    LockedFolder folder_;
};

}  // namespace dmp::cli
