// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_folder.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/folder_lock.hpp"
#include "base/nearest_name.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "cli/output_folder.hpp"
#include "cli/sweep/slurm_folder.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "cli/text.hpp"
#include "cli/version.hpp"
#include "report/limits_facts.hpp"
#include "report/study_files.hpp"
#include "report/trade_facts.hpp"
#include "report/write_report.hpp"
#include "scene/toml_node.hpp"
#include "study/input_files.hpp"
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

/// The files of the scene whose contents are others than those that the study in the folder began with.
std::vector<std::string> changed_files(const SweepContents& contents, const study::Study& study) {
    std::vector<std::string> changed;
    for (const study::InputFile& file : study::input_files(study)) {
        const auto before = contents.input_files.find(file.name);
        // One that could not be read has made no runs.
        if (before != contents.input_files.end() && !before->second.empty() && before->second != file.hash)
            changed.push_back(file.name);
    }
    return changed;
}

/// Names of what a study has left in its folder of runs: their folders, and their output (".log"). Links, and what has
/// another name, are not its own.
struct StudyRuns {
    std::vector<fs::path> folders, outputs;
};
StudyRuns runs_in(const fs::path& runs) {
    StudyRuns found;
    if (fs::symlink_status(runs).type() != fs::file_type::directory) return found;
    for (const auto& entry : fs::directory_iterator(runs)) {
        const fs::path& path = entry.path();
        const fs::file_type type = entry.symlink_status().type();
        if (type == fs::file_type::directory && is_run_name(path.filename().string())) found.folders.push_back(path);
        if (type == fs::file_type::regular && path.extension() == ".log" && is_run_name(path.stem().string()))
            found.outputs.push_back(path);
    }
    return found;
}

/// Throws where the runs of a study cannot be removed: they are elsewhere, or another process writes there.
void need_removable(const fs::path& folder) {
    const fs::path runs = folder / runs_name;
    if (fs::is_symlink(fs::symlink_status(runs)))
        throw InputError({runs.string(), 0, 0}, "it is a link: the runs of the earlier study are elsewhere",
                         "Nothing was removed. Remove the link yourself, or write into another folder with --out DIR.");
    for (const fs::path& run : runs_in(runs).folders) {
        if (!fs::exists(run / lock_file_name)) continue;
        if (const auto holder = FolderLock::take(run).holder)
            throw InputError({run.string(), 0, 0}, "another dmp is writing here: " + holder->text(),
                             "Nothing was removed. Wait for its end, or write into another folder with --out DIR.");
    }
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
    if (sweep.overwrite) return need_removable(folder);
    const std::string others = remove_it(typed) + "\n" + keep_both(folder, typed);
    if (contents.identity != study::identity_of(sweep.study)) {
        const std::string version = build_facts().version;
        throw InputError(where,
                         "it holds another study, or this one with another scene or other values: '" + contents.name +
                             "'" +
                             (contents.version.empty() || contents.version == version
                                  ? ""
                                  : "\nIt was written by dmp " + contents.version + ", and this is dmp " + version),
                         others);
    }
    if (const std::vector<std::string> changed = changed_files(contents, sweep.study); !changed.empty())
        throw InputError(where, "its runs were made with other contents of " + quoted_list(changed),
                         "To go on with it, put back what was in there. " + others);
    if (!sweep.resume)
        throw InputError(where, "it holds this study, " + progress_of(folder, sweep.runs),
                         choice("To go on with it:", typed.with("--resume")) + "\n" + others);
}

/// Removes what runs of a study have left. Others' files stay, and the folders that they are in.
std::string remove_study(const fs::path& folder) {
    std::error_code none;
    const StudyRuns runs = runs_in(folder / runs_name);
    for (const fs::path& run : runs.folders) {
        remove_results(run);
        for (const fs::path& emptied : {run / "frames", run / "checkpoints", run}) fs::remove(emptied, none);
    }
    for (const fs::path& output : runs.outputs) fs::remove(output);
    fs::remove(folder / runs_name, none);
    SlurmFolder(folder).remove();
    // What says that this is a study last: a removal that is stopped can be gone on with.
    for (const char* name : {trade_picture_name, trade_file_name, limits_picture_name, limits_file_name,
                             report_file_name, study_facts_name, study_log_name, sweep_results_name, sweep_timing_name,
                             study_copy_name, scene_copy_name, sweep_file_name})
        fs::remove(folder / name);
    return fmt::format("Removed {} of an earlier study from {}; nothing else in it was touched.\n",
                       count_text(runs.folders.size(), "run"), folder.string());
}

/// Whether anything was done for the runs of the study in this folder: one that has a file, a row in a table, a job
/// that was handed in, or an end that a job has left.
bool has_begun(const fs::path& folder) {
    const fs::path runs = folder / runs_name;
    const fs::file_type type = fs::symlink_status(runs).type();
    if (type != fs::file_type::not_found && (type != fs::file_type::directory || !fs::is_empty(runs))) return true;
    for (const char* table : {sweep_results_name, sweep_timing_name})
        if (fs::is_regular_file(folder / table) && text_lines(read_file(folder / table)).size() > 1) return true;
    const SlurmFolder jobs(folder);
    return !jobs.jobs().empty() || !jobs.ended_runs().empty();
}

/// sweep.toml.
std::string sweep_text(const NewSweep& sweep) {
    std::string text = "# Written by 'dmp sweep': of which study the runs in this folder are.\nstudy = " +
                       toml_quoted(sweep.study.name) + "\nidentity = " + toml_quoted(study::identity_of(sweep.study)) +
                       "\nruns = " + std::to_string(sweep.runs) + "\nversion = " + toml_quoted(build_facts().version) +
                       "\n";
    for (const study::InputFile& file : study::input_files(sweep.study))
        text += "\n[[input]]\nfile = " + toml_quoted(file.name) + "\nhash = " + toml_quoted(file.hash) + "\n";
    return text;
}

fs::path not_foreign(const fs::path& folder) {
    if (sweep_contents_of(folder).kind == SweepContents::Kind::foreign) throw foreign_files(folder);
    return folder;
}

/// First what makes this the folder of a study.
void write_study_files(const fs::path& folder, const NewSweep& sweep) {
    write_file(folder / sweep_file_name, sweep_text(sweep));
    make_folder(folder / runs_name);
    write_file(folder / study_copy_name, sweep.study.text);
    write_file(folder / scene_copy_name, read_file(sweep.study.scene.file));
}

}  // namespace

bool is_run_name(const std::string& name) {
    const auto only = [](std::string_view text, std::string_view characters) {
        return text.find_first_not_of(characters) == std::string_view::npos;
    };
    const auto mark = name.find('_');
    return mark != std::string::npos && mark >= 4 && name.size() == mark + 9 &&
           only(std::string_view(name).substr(0, mark), "0123456789") &&
           only(std::string_view(name).substr(mark + 1), "0123456789abcdef");
}

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
            contents.version = text_at(document, "version");
            if (const TomlNode* inputs = document.child("input"))
                for (const TomlNode& input : inputs->children)
                    contents.input_files[text_at(input, "file")] = text_at(input, "hash");
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
    // Such as one whose jobs sbatch has refused: there is nothing to go on with, and nothing to lose.
    const bool anew = contents.kind == SweepContents::Kind::study && !sweep.resume && !has_begun(path());
    if (!anew) need_fitting_contents(path(), contents, sweep, typed);
    if (!folder_.note().empty()) note_ = folder_.note() + "\n";
    if (anew) static_cast<void>(remove_study(path()));
    if (!anew && sweep.overwrite && contents.kind == SweepContents::Kind::study) note_ += remove_study(path());
    write_study_files(path(), sweep);
}

void join_sweep_folder(const fs::path& folder, const NewSweep& sweep, const TypedCommand& typed) {
    const SweepContents contents = sweep_contents_of(folder);
    if (contents.kind != SweepContents::Kind::nothing) return need_fitting_contents(folder, contents, sweep, typed);
    make_folder(folder);
    write_study_files(folder, sweep);
}

}  // namespace dmp::cli
