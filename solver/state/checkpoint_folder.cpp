// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/checkpoint_folder.hpp"

#include <charconv>
#include <iomanip>
#include <sstream>
#include <string_view>
#include <system_error>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "solver/state/checkpoint_file.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = "step_", ending = ".h5";

std::string name_of(long step) {
    std::ostringstream name;
    name << prefix << std::setw(9) << std::setfill('0') << step << ending;
    return name.str();
}

/// The step that a file is named for; none for other files' names.
std::optional<long> step_of(const std::string& name) {
    if (!name.starts_with(prefix) || !name.ends_with(ending)) return {};
    long step = 0;
    const char* const last = name.data() + name.size() - ending.size();
    const auto [end, failed] = std::from_chars(name.data() + prefix.size(), last, step);
    if (failed != std::errc() || end != last || step < 0 || name != name_of(step)) return {};
    return step;
}

/// Is this a file that a CheckpointWriter began and did not finish?
bool is_unfinished(const fs::path& file) {
    const auto finished = finished_name(file);
    return finished && step_of(finished->filename().string());
}

[[noreturn]] void throw_folder_error(const fs::path& folder, const std::error_code& failed) {
    throw InputError(Place{folder.string(), 0, 0}, "cannot be looked into: " + failed.message(),
                     "Check that it is a folder and that you may read it.");
}

/// The files in the folder; none when there is no folder.
std::vector<fs::path> files_in(const fs::path& folder) {
    std::error_code failed;
    std::vector<fs::path> files;
    if (!fs::exists(folder, failed) && !failed) return files;
    fs::directory_iterator entry(folder, failed);
    for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) files.push_back(entry->path());
    if (failed) throw_folder_error(folder, failed);
    return files;
}

void remove_checkpoint(const fs::path& file) {
    std::error_code failed;
    fs::remove(file, failed);
    if (failed)
        throw ResourceError("cannot remove the old checkpoint '" + file.string() + "': " + failed.message(),
                            "Check that you may write to its folder.");
}

}  // namespace

void CheckpointFolder::make() const { make_folder(folder_); }

fs::path CheckpointFolder::path_for(long step) const { return folder_ / name_of(step); }

CheckpointFolder::NewestFirst CheckpointFolder::checkpoints() const {
    NewestFirst found;
    for (const fs::path& file : files_in(folder_))
        if (const auto step = step_of(file.filename().string())) found.emplace(*step, file);
    return found;
}

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

std::optional<FoundCheckpoint> CheckpointFolder::newest_good() {
    good_.clear();
    struct Bad {
        fs::path file;
        std::string problem;
    };
    std::vector<Bad> bad;
    const auto all = checkpoints();
    for (const auto& [step, file] : all) {
        const std::string problem = problem_with(step, file);
        if (!problem.empty()) {
            bad.push_back({file, problem});
            continue;
        }
        FoundCheckpoint found{file, step, {}};
        for (std::size_t n = 0; n < bad.size(); ++n)
            found.messages.push_back(bad[n].file.string() + " is " + bad[n].problem + "; using " +
                                     (n + 1 == bad.size() ? "the one before it" : "an earlier one") + ", step " +
                                     std::to_string(step));
        return found;
    }
    if (bad.empty()) return {};
    std::string problem = "none of its checkpoints can be used";
    for (const Bad& one : bad) problem += "\n" + one.file.filename().string() + " is " + one.problem;
    throw InputError(Place{folder_.string(), 0, 0}, problem,
                     "Restore one from a copy, or run the scene from its start.");
}

void CheckpointFolder::keep_last_two(long written) {
    good_.insert(written);
    std::optional<long> before;
    const auto all = checkpoints();
    for (const auto& [step, file] : all) {
        if (step == written) continue;
        if (step < written && !before && problem_with(step, file).empty()) {
            before = step;
            continue;
        }
        good_.erase(step);
        remove_checkpoint(file);
    }
    for (const fs::path& file : files_in(folder_))
        if (is_unfinished(file)) remove_checkpoint(file);
}

}  // namespace dmp
