// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_folder.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "postproc/paraview_script.hpp"
#include "postproc/tables.hpp"
#include "solver/output/frame_file.hpp"
#include "solver/output/frame_index.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> marks{"fluid.pvd",      "solid.pvd",       "walls.vtp",
                                                frame_index_name, summary_file_name, resolved_scene_name};

bool is_own(const fs::path& file) {
    const std::string name = file.filename().string();
    const bool in_frames = file.parent_path().filename() == "frames";
    if (in_frames) return name.ends_with(".vtp") && (name.starts_with("fluid_") || name.starts_with("solid_"));
    constexpr std::array<std::string_view, 9> others{measures_file_name, paraview_script_name, mesh_report_name,
                                                     "last_frame.png",   "cycle.png",          "measures.png",
                                                     "slices.png",       "surface_error.png",  "valence.png"};
    return std::ranges::find(marks, name) != marks.end() || std::ranges::find(others, name) != others.end();
}

/// Also what a run leaves that was killed before its first file: that file unfinished, or a folder for frames.
bool is_of_dmp(const fs::path& folder) {
    const auto is_there = [&](std::string_view name) {
        return fs::exists(folder / name) || fs::exists(unfinished_name(folder / name));
    };
    if (std::ranges::any_of(marks, is_there)) return true;
    return std::ranges::all_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
        return entry.path().filename() == "frames" && entry.is_directory() && fs::is_empty(entry.path());
    });
}

/// Removes dmp's own files, also those that a killed run left unfinished; folders that this empties go too.
std::size_t remove_own(const fs::path& folder) {
    // Checkpoints first: none may outlive the frames it goes on from.
    std::size_t removed = CheckpointFolder(folder).remove();
    removed += remove_frames(folder, 0);
    for (const auto& position : {folder / "frames", folder}) {
        if (!fs::is_directory(position)) continue;
        for (const auto& entry : fs::directory_iterator(position)) {
            if (entry.is_regular_file() && is_own(finished_name(entry.path()).value_or(entry.path())))
                removed += fs::remove(entry.path()) ? 1 : 0;
        }
    }
    if (fs::is_directory(folder / "frames") && fs::is_empty(folder / "frames")) fs::remove(folder / "frames");
    return removed;
}

}  // namespace

fs::path output_folder(const std::string& asked, const std::string& name) {
    return asked.empty() ? fs::path("out") / name : fs::path(asked);
}

std::string prepare_folder(const fs::path& folder) {
    make_folder(folder);
    if (fs::is_empty(folder)) return "";
    if (!is_of_dmp(folder)) {
        throw InputError({folder.string()}, "the output folder holds files that are not dmp's",
                         "Nothing was written. Choose an empty or a new folder with --out DIR.");
    }
    const std::size_t removed = remove_own(folder);
    if (removed == 0) return "";
    return fmt::format("Removed {} of an earlier run from {}; nothing else in it was touched.",
                       count_text(removed, "file"), folder.string());
}

}  // namespace dmp::cli
