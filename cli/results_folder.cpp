// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/results_folder.hpp"

#include <fmt/format.h>

#include "cli/uses.hpp"
#include "scene/scene_difference.hpp"
#include "solver/output/frame_index.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

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
            "A finished run goes on with a later --until or run.duration. Where it was killed before its pictures and "
            "its " +
                fmt::format("page were there, 'dmp pictures {0}' and 'dmp report {0}' make them.",
                            shell_word(folder.string()))};
}

/// Not even a lock goes into a folder of others.
const fs::path& not_foreign(const fs::path& folder) {
    if (contents_of(folder).kind == FolderContents::Kind::foreign) throw foreign_files(folder);
    return folder;
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
    : folder_(not_foreign(folder), beside(folder, typed)) {
    using enum FolderContents::Kind;
    const FolderContents contents = contents_of(path());
    if (contents.kind != nothing && !run.resume && !run.overwrite) throw refusal(path(), contents, run, typed);
    if (contents.kind == finished && run.resume && !is_longer(run, contents))
        throw finished_already(path(), contents, run);
}

ResultsFolder::ResultsFolder(const fs::path& folder, const TypedCommand& typed)
    : folder_(not_foreign(folder), beside(folder, typed)) {
    using enum FolderContents::Kind;
    const auto kind = contents_of(path()).kind;
    if (kind != nothing && kind != mesh)
        throw InputError({path().string()}, "it holds the results of a run", keep_both(path(), typed));
}

ResultsFolder ResultsFolder::of_run(const fs::path& folder) {
    return ResultsFolder(folder, "convert a copy of " + (folder / "frames").string() + " and " +
                                     (folder / frame_index_name).string() + " in another folder.");
}

}  // namespace dmp::cli
