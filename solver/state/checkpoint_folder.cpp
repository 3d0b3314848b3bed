// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/checkpoint_folder.hpp"

#include <functional>
#include <map>

#include "base/errors.hpp"
#include "base/numbered_files.hpp"
#include "base/safe_file.hpp"
#include "solver/state/checkpoint_file.hpp"

namespace dmp::solver {

namespace fs = std::filesystem;

namespace {

const NumberedFiles& files() {
    static const NumberedFiles kind("step_", 9, ".h5");
    return kind;
}

/// The checkpoints in a folder by step, newest first.
std::map<long, fs::path, std::greater<>> newest_first(const fs::path& folder) {
    const auto found = files().in(folder);
    return {found.begin(), found.end()};
}

}  // namespace

void CheckpointFolder::make() const { make_folder(folder_); }

fs::path CheckpointFolder::path_for(long step) const { return folder_ / files().name(step); }

std::string CheckpointFolder::problem_with(long step, const fs::path& file) {
    if (good_.contains(step)) return "";
    try {
        check_seal(file, checkpoint_kind);
    } catch (const InputError& error) {
        return error.problem();
    }
    good_.insert(step);
    return "";
}

std::vector<FoundCheckpoint> CheckpointFolder::all_good() {
    good_.clear();
    std::vector<FoundCheckpoint> good;
    std::vector<std::string> left_out;
    for (const auto& [step, file] : newest_first(folder_)) {
        if (const std::string problem = problem_with(step, file); !problem.empty())
            left_out.push_back(file.string() + " is " + problem + "; it is left out");
        else
            good.push_back({file, step, 0, left_out, {}});
    }
    return good;
}

std::optional<FoundCheckpoint> CheckpointFolder::newest_good() {
    good_.clear();
    struct Bad {
        fs::path file;
        std::string problem;
    };
    std::vector<Bad> bad;
    for (const auto& [step, file] : newest_first(folder_)) {
        const std::string problem = problem_with(step, file);
        if (!problem.empty()) {
            bad.push_back({file, problem});
            continue;
        }
        FoundCheckpoint found{file, step, 0, {}, {}};
        for (std::size_t n = 0; n < bad.size(); ++n)
            found.messages.push_back(bad[n].file.string() + " is " + bad[n].problem + "; using " +
                                     (n + 1 == bad.size() ? "the one before it" : "an earlier one") + ", step " +
                                     std::to_string(step));
        return found;
    }
    if (bad.empty()) return {};
    std::string problem = "none of its checkpoints can be used";
    for (const Bad& one : bad) problem += "\n" + one.file.filename().string() + " is " + one.problem;
    throw InputError(SourceLocation{folder_.string(), 0, 0}, problem,
                     "Restore one from a copy, or run the scene from its start.");
}

void CheckpointFolder::keep_last_two(long written) {
    good_.insert(written);
    std::optional<long> before;
    for (const auto& [step, file] : newest_first(folder_)) {
        if (step == written) continue;
        if (step < written && !before && problem_with(step, file).empty()) {
            before = step;
            continue;
        }
        good_.erase(step);
        remove_file(file);
    }
    for (const fs::path& file : files().unfinished_in(folder_)) remove_file(file);
}

std::size_t CheckpointFolder::remove() {
    good_.clear();
    std::vector<fs::path> all = files().unfinished_in(folder_);
    for (const auto& [step, file] : newest_first(folder_)) all.push_back(file);
    for (const fs::path& file : all) remove_file(file);
    if (fs::is_directory(folder_) && fs::is_empty(folder_)) remove_file(folder_);
    return all.size();
}

}  // namespace dmp::solver
