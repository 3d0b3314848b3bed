// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_folder.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/output_folder.hpp"
#include "cli/sweep_table.hpp"
#include "cli/text.hpp"
#include "cli/version.hpp"
#include "scene/toml_node.hpp"
#include "study/points.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* runs_name = "runs";

std::string text_at(const TomlNode& document, const char* key) {
    const TomlNode* value = document.child(key);
    return value != nullptr && value->is_text() ? value->text.text : "";
}

/// "3 of 12 runs done"
std::string progress_of(const fs::path& folder, std::size_t runs) {
    std::size_t finished = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder / runs_name, none))
        finished += contents_of(entry.path()).kind == FolderContents::Kind::finished ? 1 : 0;
    return fmt::format("{} of {} done", count_text(finished), count_text(runs, "run"));
}

/// Throws where the folder holds what the command line does not say what to do with.
void need_fitting_contents(const fs::path& folder, const SweepContents& contents, const NewSweep& sweep,
                           const TypedCommand& typed) {
    const SourceLocation where{folder.string(), 0, 0};
    switch (contents.kind) {
        case SweepContents::Kind::foreign:
            throw foreign_files(folder);
        case SweepContents::Kind::nothing:
            if (sweep.resume)
                throw InputError(where, "there is no study to go on with",
                                 "Start it without --resume, or give its folder with --out DIR.");
            return;
        case SweepContents::Kind::study:
            break;
    }
    if (sweep.overwrite) return;
    const std::string others = remove_it(typed) + "\n" + keep_both(folder, typed);
    if (contents.identity != study::identity_of(sweep.study))
        throw InputError(
            where, "it holds another study, or this one with another scene or other values: '" + contents.name + "'",
            others);
    if (!sweep.resume)
        throw InputError(where, "it holds this study, " + progress_of(folder, sweep.runs),
                         choice("To go on with it:", typed.with("--resume")) + "\n" + others);
}

/// Removes what runs of a study have left. Others' files stay, and the folders that they are in.
std::string remove_study(const fs::path& folder) {
    std::size_t runs = 0;
    std::error_code none;
    if (fs::is_directory(folder / runs_name)) {
        for (const auto& entry : fs::directory_iterator(folder / runs_name)) {
            if (entry.is_directory()) {
                remove_results(entry.path());
                for (const fs::path& emptied : {entry.path() / "frames", entry.path() / "checkpoints", entry.path()})
                    fs::remove(emptied, none);
                ++runs;
            } else if (entry.path().extension() == ".log") {
                fs::remove(entry.path());
            }
        }
        fs::remove(folder / runs_name, none);
    }
    // What says that this is a study last: a removal that is stopped can be gone on with.
    for (const char* name : {sweep_results_name, sweep_timing_name, study_copy_name, scene_copy_name, sweep_file_name})
        fs::remove(folder / name);
    return fmt::format("Removed {} of an earlier study from {}; nothing else in it was touched.\n",
                       count_text(runs, "run"), folder.string());
}

fs::path not_foreign(const fs::path& folder) {
    if (sweep_contents_of(folder).kind == SweepContents::Kind::foreign) throw foreign_files(folder);
    return folder;
}

}  // namespace

SweepContents sweep_contents_of(const fs::path& folder) {
    SweepContents contents;
    if (!fs::is_directory(folder)) return contents;
    const fs::path file = folder / sweep_file_name;
    if (fs::is_regular_file(file)) {
        contents.kind = SweepContents::Kind::study;
        try {
            const TomlNode document = parse_toml(read_file(file), file.string());
            contents.name = text_at(document, "study");
            contents.identity = text_at(document, "identity");
        } catch (const InputError&) {  // of a study that nobody can tell
            contents.identity.clear();
        }
        return contents;
    }
    const auto negligible = [](const fs::directory_entry& entry) {
        return is_lock_file(entry.path()) || finished_name(entry.path()).has_value();
    };
    std::error_code none;
    if (!std::ranges::all_of(fs::directory_iterator(folder, none), negligible))
        contents.kind = SweepContents::Kind::foreign;
    return contents;
}

fs::path run_folder(const fs::path& folder, const std::string& run) { return folder / runs_name / run; }

fs::path run_output(const fs::path& folder, const std::string& run) { return folder / runs_name / (run + ".log"); }

SweepFolder::SweepFolder(const fs::path& folder, const NewSweep& sweep, const TypedCommand& typed)
    : folder_(not_foreign(folder), beside(folder, typed)) {
    const SweepContents contents = sweep_contents_of(path());
    need_fitting_contents(path(), contents, sweep, typed);
    if (!folder_.note().empty()) note_ = folder_.note() + "\n";
    if (sweep.overwrite && contents.kind == SweepContents::Kind::study) note_ += remove_study(path());
    // First, as it is what makes this the folder of a study.
    write_file(path() / sweep_file_name,
               "# Written by 'dmp sweep': of which study the runs in this folder are.\nstudy = " +
                   toml_quoted(sweep.study.name) + "\nidentity = " + toml_quoted(study::identity_of(sweep.study)) +
                   "\nruns = " + std::to_string(sweep.runs) + "\nversion = " + toml_quoted(build_facts().version) +
                   "\n");
    make_folder(path() / runs_name);
    write_file(path() / study_copy_name, read_file(sweep.study.file));
    write_file(path() / scene_copy_name, read_file(sweep.study.scene.file));
}

}  // namespace dmp::cli
