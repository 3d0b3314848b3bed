// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/parallel/resources.hpp"
#include "solver/results/plan.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::cli {

/// Writes folder/scene.resolved.toml: the scene with all defaults, as one that can be read there. Files that it names
/// are found from the folder. A default that scenes may not give (one that is for other kinds of parts, say) is a
/// comment: "# KEY = VALUE". Throws ResourceError.
void write_scene(const std::filesystem::path& folder, const Scene& scene);

/// The same of a run to `until` [s], which it repeats; with `until` before the scene's duration not to the last bit
/// where formulas of t were sampled over that duration (drive_time, amounts of species). What the plan chose stands in
/// place of "auto", where that is one number (the speed of sound, the strength of the repulsion, the time between
/// measures), and `until` in place of the duration. Comments hold what the scene says (with_values_of), and where the
/// run took its first state from.
void write_scene_of_run(const std::filesystem::path& folder, const Scene& scene, const Plan& plan,
                        const Resources& resources, double until, const std::optional<StartedFrom>& started_from = {});

}  // namespace dmp::cli
