// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace dmp::cli {

/// The scene as it was run, every default filled in; written before anything else.
inline constexpr const char* resolved_scene_name = "scene.resolved.toml";

/// The figures of a mesh's report, for programs; written before the particles, so that a folder with it and without a
/// run's files is a mesh's.
inline constexpr const char* mesh_report_name = "mesh_report.json";

/// The folder the results go to: `asked`, or out/NAME below the current folder.
[[nodiscard]] std::filesystem::path output_folder(const std::string& asked, const std::string& name);

/// What is in a folder for results.
struct FolderContents {
    enum class Kind {
        nothing,     ///< no folder, an empty one, or what a run left that ended before its first frame
        foreign,     ///< files, and none of dmp's
        mesh,        ///< what 'dmp mesh' leaves
        unfinished,  ///< a run that was stopped or killed, or that diverged
        finished     ///< a run that reached its end
    };
    Kind kind = Kind::nothing;
    std::string scene;            ///< of a run: its resolved scene; "" if it is not there
    bool has_checkpoint = false;  ///< of a run
    double simulated_s = 0;       ///< of a run with a summary: the time it got to [s]
};

/// Looks only.
[[nodiscard]] FolderContents contents_of(const std::filesystem::path& folder);

/// Removes dmp's own files, also those that a killed run left unfinished; others stay, and so do folders.
/// Returns a line that says so when something was removed, else "".
std::string remove_results(const std::filesystem::path& folder);

}  // namespace dmp::cli
