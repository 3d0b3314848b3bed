// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/results_folder.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/stop_signals.hpp"
#include "cli/uses.hpp"
#include "scene/scene_difference.hpp"
#include "solver/output/frame_index.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

std::string choice(const std::string& what, const std::string& line) { return what + "\n  " + line; }

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

/// Where a finished run ends.
std::string end_text(const FolderContents& contents) {
    return fmt::format("finished at t = {:.6g} s", contents.simulated_s);
}

bool is_longer(const NewRun& run, const FolderContents& contents) {
    return run.until > contents.simulated_s * (1 + 1e-9);
}

InputError finished_already(const fs::path& folder, const FolderContents& contents, const NewRun& run) {
    return {SourceLocation{folder.string(), 0, 0},
            fmt::format("it holds a run that is {}, and is asked to end at {:.6g} s", end_text(contents), run.until),
            "A finished run goes on with a later --until or run.duration."};
}

}  // namespace

InputError refusal(const fs::path& folder, const FolderContents& contents, const NewRun& run,
                   const TypedCommand& typed) {
    using enum FolderContents::Kind;
    const SourceLocation where{folder.string(), 0, 0};
    if (contents.kind == foreign) return foreign_files(folder);
    const std::string both = keep_both(folder, typed), replace = remove_it(typed);
    if (contents.kind == mesh) return {where, "it holds particles that 'dmp mesh' made", both + "\n" + replace};

    const std::string run_there = contents.kind == finished ? "a finished run" : "an unfinished run";
    const auto changed =
        contents.scene.empty() ? std::vector<ValueDifference>{} : differences(contents.scene, run.scene);
    if (!contents.scene.empty() && !differences_in_state(contents.scene, run.scene).empty())
        return {where, "it holds " + run_there + " of another scene or other values:" + differences_text(changed),
                both + "\n" + replace};
    const std::string but =
        changed.empty() ? "" : "; these values may change as it goes on:" + differences_text(changed);
    if (contents.kind == finished && !is_longer(run, contents))
        return {where, "it holds this run already, " + end_text(contents) + but,
                "Its results are there to be looked at; summary.json lists the files.\n" + both + "\n" + replace};
    const std::string state = contents.kind == finished
                                  ? fmt::format("{}; this one would end at {:.6g} s", end_text(contents), run.until)
                                  : "unfinished";
    if (!contents.has_checkpoint && contents.kind == unfinished)
        return {where, "it holds a run that did not get to its end and has no checkpoint to go on from",
                both + "\n" + replace};
    if (!contents.has_checkpoint)
        return {where, "it holds this run, " + state + ", and no checkpoint to go on from", both + "\n" + replace};
    return {where, "it holds this run, " + state + but,
            choice("To go on with it:", typed.with("--resume")) + "\n" + replace + "\n" + both};
}

ResultsFolder::ResultsFolder(const fs::path& folder, const NewRun& run, const TypedCommand& typed)
    : ResultsFolder(folder) {
    using enum FolderContents::Kind;
    make_and_lock(typed);
    const FolderContents contents = contents_of(folder_);
    if (contents.kind != nothing && !run.resume && !run.overwrite) throw refusal(folder_, contents, run, typed);
    if (contents.kind == finished && run.resume && !is_longer(run, contents))
        throw finished_already(folder_, contents, run);
}

ResultsFolder::ResultsFolder(const fs::path& folder, const TypedCommand& typed) : ResultsFolder(folder) {
    using enum FolderContents::Kind;
    make_and_lock(typed);
    const auto kind = contents_of(folder_).kind;
    if (kind != nothing && kind != mesh)
        throw InputError({folder_.string()}, "it holds the results of a run", keep_both(folder_, typed));
}

ResultsFolder ResultsFolder::of_run(const fs::path& folder) {
    return ResultsFolder(folder, "convert a copy of " + (folder / "frames").string() + " and " +
                                     (folder / frame_index_name).string() + " in another folder.");
}

ResultsFolder::ResultsFolder(fs::path folder, const std::string& instead) : ResultsFolder(std::move(folder)) {
    lock(instead);
}

ResultsFolder::~ResultsFolder() {
    lock_.reset();
    if (first_made_.empty()) return;
    // Folders with anything in them cannot be removed.
    std::error_code in_use;
    for (fs::path made = folder_; fs::remove(made, in_use) && made != first_made_;) made = made.parent_path();
}

void ResultsFolder::make_and_lock(const TypedCommand& typed) {
    // Not even a lock goes into a folder of others.
    if (contents_of(folder_).kind == FolderContents::Kind::foreign) throw foreign_files(folder_);
    for (fs::path above = folder_; !above.empty() && !fs::exists(above); above = above.parent_path())
        first_made_ = above;
    lock("write beside it:\n  " + typed.into(next_free(folder_)));
}

void ResultsFolder::lock(const std::string& instead) {
    remove_lock_on_signals();
    FolderLock::Outcome outcome = lock_in(folder_);
    if (outcome.holder) throw held(folder_, *outcome.holder, instead);
    lock_ = std::move(outcome.lock);
    if (outcome.taken_from)
        note_ = "An earlier dmp has ended without removing its lock (" + outcome.taken_from->text() + "); taken over.";
}

}  // namespace dmp::cli
