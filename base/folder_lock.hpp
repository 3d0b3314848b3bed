// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/process_identity.hpp"
#include "base/wall_clock.hpp"

namespace dmp {

/// The file in a folder that says who writes there.
inline constexpr const char* lock_file_name = "dmp.lock";

/// Whether a file is a lock, or one of those that are there for a moment while a lock is taken.
[[nodiscard]] bool is_lock_file(const std::filesystem::path& file);

/// What a lock file says.
struct LockHolder {
    ProcessIdentity process;  ///< pid 0: the file cannot be read
    std::string since;        ///< when the lock was taken, "2026-11-25 23:26:52 UTC"
    std::string token;        ///< a random number of this one lock
    double silent_s = 0;      ///< since its last sign of life, by the clock of the file system [s]

    /// "process 1234 on node17, since 2026-11-25 23:26:52 UTC"
    [[nodiscard]] std::string text() const;
};

/// Keeps a folder for one process, also where other machines see it (NFS).
///
/// The lock is a file that is made whole under another name and then linked, which only one process can do, also over
/// NFS. While the lock is held, the file's time is renewed. A lock is stale when its process has ended, which is seen
/// on the same machine, or when a process of another machine has not renewed it for `silence_limit_s`. Before a stale
/// lock is removed, the right to do so is taken in the same way, by a file named after the lock's token: nobody can
/// remove a new lock for the stale one that was there before.
class FolderLock {
  public:
    static constexpr double renewal_s = 15;         ///< time between signs of life
    static constexpr double silence_limit_s = 300;  ///< the file system may hang for a while

    /// The lock, or who has it; `taken_from` is the holder of a stale lock that was in its place.
    struct Outcome {
        std::unique_ptr<FolderLock> lock;
        std::optional<LockHolder> holder, taken_from;
    };

    /// The folder must exist. Throws ResourceError if a file cannot be made there.
    [[nodiscard]] static Outcome take(const std::filesystem::path& folder);

    /// Removes the file, if it is still this lock's.
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Gives a sign of life; makes the file again where somebody has removed it.
    void renew();

    /// Throws ResourceError if another process has taken the folder: this one seemed to have ended.
    void check();

  private:
    FolderLock(std::filesystem::path folder, std::string token);

    [[nodiscard]] std::filesystem::path file() const { return folder_ / lock_file_name; }

    std::filesystem::path folder_;
    std::string token_;
    std::mutex mutex_;
    WallClock::time_point renewed_ = WallClock::now();  ///< guarded by mutex_
    std::atomic<bool> lost_ = false;
    std::condition_variable_any ended_;
    std::jthread renewal_;  // last: it uses the others
};

/// For signal handlers: removes the file of the lock that this process holds, if any.
void remove_held_lock() noexcept;

}  // namespace dmp
