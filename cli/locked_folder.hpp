// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/errors.hpp"
#include "base/folder_lock.hpp"
#include "cli/typed_command.hpp"

namespace dmp::cli {

/// A folder that is locked while this object lives. One that was made for it goes again if nothing was written. A
/// signal that ends dmp removes the lock, too.
class LockedFolder {
  public:
    /// Makes it where it is missing. Throws InputError if it cannot be made or written to, or another process writes
    /// there; `instead`: what else can be done then than to wait.
    LockedFolder(std::filesystem::path folder, const std::string& instead);
    ~LockedFolder();
    LockedFolder(const LockedFolder&) = delete;
    LockedFolder& operator=(const LockedFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
    /// What to tell of a process that ended without removing its lock; "" if there was none.
    [[nodiscard]] const std::string& note() const { return note_; }
    /// Throws ResourceError if another process has taken the folder.
    void check() const { lock_->check(); }

  private:
    void remove_if_empty() const;

    std::filesystem::path folder_;
    std::filesystem::path first_made_;  ///< the uppermost folder that was made for it; "" if none
    std::unique_ptr<FolderLock> lock_;
    std::string note_;
};

/// The error for a folder that holds what dmp has not written.
[[nodiscard]] InputError foreign_files(const std::filesystem::path& folder);

// What to do about a folder that holds something: what, and a line to paste.
[[nodiscard]] std::string choice(const std::string& what, const std::string& line);
[[nodiscard]] std::string beside(const std::filesystem::path& folder, const TypedCommand& typed);
[[nodiscard]] std::string keep_both(const std::filesystem::path& folder, const TypedCommand& typed);
[[nodiscard]] std::string remove_it(const TypedCommand& typed);

}  // namespace dmp::cli
