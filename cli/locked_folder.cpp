// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/locked_folder.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/stop_signals.hpp"
#include "cli/uses.hpp"

namespace dmp::cli {

namespace fs = std::filesystem;

std::string choice(const std::string& what, const std::string& line) { return what + "\n  " + line; }

std::string beside(const fs::path& folder, const TypedCommand& typed) {
    return choice("write beside it:", typed.into(next_free(folder)));
}

std::string keep_both(const fs::path& folder, const TypedCommand& typed) {
    return choice("To keep it and write beside it:", typed.into(next_free(folder)));
}

std::string remove_it(const TypedCommand& typed) {
    return choice("To remove it and run in its place:", typed.with("--overwrite"));
}

InputError foreign_files(const fs::path& folder) {
    return {SourceLocation{folder.string(), 0, 0}, "the output folder holds files that are not dmp's",
            "Nothing was written. Choose an empty or a new folder with --out DIR."};
}

namespace {

InputError held(const fs::path& folder, const LockHolder& holder, const std::string& instead) {
    std::string what_to_do = "Wait for its end, or " + instead;
    if (holder.process.pid == 0 || state_of(holder.process) == ProcessState::unknown)
        what_to_do +=
            fmt::format("\nIts last sign of life came {:.0f} s ago; after {:.0f} min without one it counts as ended.",
                        std::max(holder.silent_s, 0.0), FolderLock::silence_limit_s / 60);
    return {SourceLocation{folder.string(), 0, 0}, "another dmp is writing here: " + holder.text(), what_to_do};
}

/// The lock of a folder that is made where it is missing. One that was refused here may just remove it.
FolderLock::Outcome lock_in(const fs::path& folder) {
    constexpr int most_tries = 10;
    for (int tries = 1;; ++tries) {
        make_folder(folder);
        try {
            return FolderLock::take(folder);
        } catch (const ResourceError&) {
            if (tries == most_tries || fs::exists(folder)) throw;
        }
    }
}

}  // namespace

LockedFolder::LockedFolder(fs::path folder, const std::string& instead) : folder_(std::move(folder)) {
    for (fs::path above = folder_; !above.empty() && !fs::exists(above); above = above.parent_path())
        first_made_ = above;
    remove_lock_on_signals();
    FolderLock::Outcome outcome;
    try {
        outcome = lock_in(folder_);
    } catch (...) {
        remove_if_empty();
        throw;
    }
    if (outcome.holder) {
        remove_if_empty();
        throw held(folder_, *outcome.holder, instead);
    }
    lock_ = std::move(outcome.lock);
    if (outcome.taken_from)
        note_ = "An earlier dmp has ended without removing its lock (" + outcome.taken_from->text() + "); taken over.";
}

LockedFolder::~LockedFolder() {
    lock_.reset();
    remove_if_empty();
}

void LockedFolder::remove_if_empty() const {
    if (first_made_.empty()) return;
    // Folders with anything in them cannot be removed.
    std::error_code in_use;
    for (fs::path made = folder_; fs::remove(made, in_use) && made != first_made_;) made = made.parent_path();
}

}  // namespace dmp::cli
