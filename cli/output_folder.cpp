// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_folder.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/folder_lock.hpp"
#include "base/safe_file.hpp"
#include "cli/run_log.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "postproc/paraview_script.hpp"
#include "postproc/pictures.hpp"
#include "postproc/tables.hpp"
#include "report/write_report.hpp"
#include "solver/output/frame_file.hpp"
#include "solver/output/frame_index.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Files of which a folder with results has at least one.
constexpr std::array<std::string_view, 8> marks{"fluid.pvd", "solid.pvd",      "spheres.pvd",     "moving_walls.pvd",
                                                "walls.vtp", frame_index_name, summary_file_name, resolved_scene_name};

/// "measures_2.csv": what keep_other_measures has left.
bool is_kept_measures(std::string_view name) {
    constexpr std::string_view before = "measures_", after = ".csv";
    if (!name.starts_with(before) || !name.ends_with(after) || name.size() <= before.size() + after.size())
        return false;
    const std::string_view number = name.substr(before.size(), name.size() - before.size() - after.size());
    return std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_own(const fs::path& file) {
    const std::string name = file.filename().string();
    if (file.parent_path().filename() == "frames") {
        constexpr std::array<std::string_view, 4> groups{"fluid_", "solid_", "spheres_", "moving_walls_"};
        return name.ends_with(".vtp") &&
               std::ranges::any_of(groups, [&](std::string_view group) { return name.starts_with(group); });
    }
    if (is_kept_measures(name)) return true;
    constexpr std::array<std::string_view, 13> others{
        references_file_name, report_file_name,    film_file_name,   run_log_name, measures_file_name,
        paraview_script_name, mesh_report_name,    "last_frame.png", "cycle.png",  "measures.png",
        "slices.png",         "surface_error.png", "valence.png"};
    return std::ranges::find(marks, name) != marks.end() || std::ranges::find(others, name) != others.end();
}

/// Nothing that anybody misses: locks, empty folders of a run, a file that was begun.
bool is_negligible(const fs::directory_entry& entry) {
    const fs::path& file = entry.path();
    if (entry.is_directory()) {
        const auto name = file.filename();
        return (name == "frames" || name == "checkpoints") && fs::is_empty(file);
    }
    return is_lock_file(file) || is_own(finished_name(file).value_or("other"));
}

bool has_checkpoint(const fs::path& folder) {
    std::error_code none;
    return std::ranges::any_of(fs::directory_iterator(folder / "checkpoints", none), [](const auto& entry) {
        const std::string name = entry.path().filename().string();
        return name.starts_with("step_") && name.ends_with(".h5");
    });
}

std::string text_of(const fs::path& file) {
    try {
        return read_file(file);
    } catch (const InputError&) {
        return "";
    }
}

}  // namespace

fs::path output_folder(const std::string& asked, const std::string& name) {
    return asked.empty() ? fs::path("out") / name : fs::path(asked);
}

FolderContents contents_of(const fs::path& folder) {
    using enum FolderContents::Kind;
    if (!fs::is_directory(folder)) return {};
    const auto is_there = [&](std::string_view name) { return fs::exists(folder / name); };
    const auto is_begun = [&](std::string_view name) { return fs::exists(unfinished_name(folder / name)); };
    FolderContents found;
    found.has_checkpoint = has_checkpoint(folder);
    if (is_there(mesh_report_name) && !is_there(summary_file_name) && !found.has_checkpoint) {
        found.kind = mesh;
        return found;
    }
    // A scene alone is of a run that ended before its first frame.
    const bool has_frames = std::ranges::any_of(
        marks, [&](std::string_view name) { return name != resolved_scene_name && is_there(name); });
    if (has_frames || found.has_checkpoint) {
        const auto end = read_run_end(folder);
        found.kind = end && !end->interrupted ? finished : unfinished;
        found.simulated_s = end ? end->simulated_s : 0;
        found.scene = text_of(folder / resolved_scene_name);
        return found;
    }
    if (is_there(resolved_scene_name) || std::ranges::any_of(marks, is_begun)) return found;
    try {
        if (std::ranges::all_of(fs::directory_iterator(folder), is_negligible)) return found;
        // Another dmp may have begun to write here after the first look.
        if (std::ranges::any_of(marks, is_there) || std::ranges::any_of(marks, is_begun)) return contents_of(folder);
        found.kind = foreign;
    } catch (const fs::filesystem_error& error) {
        // Another dmp that was refused may just remove the folder.
        if (error.code() != std::errc::no_such_file_or_directory) throw;
    }
    return found;
}

std::string remove_results(const fs::path& folder) {
    // Checkpoints first: none may outlive the frames it goes on from.
    std::size_t removed = CheckpointFolder(folder).remove();
    // What is left of a run whose removal was stopped may not count as finished.
    if (fs::is_regular_file(folder / summary_file_name)) removed += fs::remove(folder / summary_file_name) ? 1 : 0;
    removed += remove_frames(folder, 0);
    for (const auto& position : {folder / "frames", folder}) {
        if (!fs::is_directory(position)) continue;
        for (const auto& entry : fs::directory_iterator(position)) {
            if (entry.is_regular_file() && is_own(finished_name(entry.path()).value_or(entry.path())))
                removed += fs::remove(entry.path()) ? 1 : 0;
        }
    }
    if (removed == 0) return "";
    return fmt::format("Removed {} of an earlier run from {}; nothing else in it was touched.",
                       count_text(removed, "file"), folder.string());
}

}  // namespace dmp::cli
