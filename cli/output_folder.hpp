// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace dmp::cli {

/// The scene as it was run, every default filled in; written before anything else.
inline constexpr const char* resolved_scene_name = "scene.resolved.toml";

/// The figures of a mesh's report, for programs.
inline constexpr const char* mesh_report_name = "mesh_report.json";

/// The folder the results go to: `asked`, or out/NAME below the current folder.
[[nodiscard]] std::filesystem::path output_folder(const std::string& asked, const std::string& name);

/// Makes the folder, or empties it of the files an earlier run of dmp left there; others stay.
/// Returns a line that says so when something was removed, else "".
/// Throws InputError for a folder with things in it that is none of dmp's, and one that cannot be made or written to.
std::string prepare_folder(const std::filesystem::path& folder);

}  // namespace dmp::cli
