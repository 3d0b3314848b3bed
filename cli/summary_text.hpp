// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

/// What a person wants to know at the end of a run.
[[nodiscard]] std::string summary_text(const Scene& scene, const RunSummary& summary);

/// Where the results are and how to open them. `files` are relative to the folder.
[[nodiscard]] std::string results_text(const std::filesystem::path& folder, const std::vector<std::string>& files);

}  // namespace dmp::cli
