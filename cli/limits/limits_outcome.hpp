// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/limits/limits_request.hpp"
#include "cli/limits/rung_ends.hpp"
#include "cli/uses.hpp"
#include "report/limits_facts.hpp"

namespace dmp::cli {

/// The folder that `dmp limits` writes a scene's limits into where none is given.
[[nodiscard]] std::filesystem::path default_limits_folder(const Scene& scene);

/// What is known of the limits by the runs that have ended. `names`: of the runs.
[[nodiscard]] LimitsFacts limits_found(const LimitsRequest& request, const std::string& scene, RungEnds& ends,
                                       const study::Points& points);

/// For people: the table of the dials.
[[nodiscard]] std::string limits_text(const LimitsFacts& limits);

/// limits.json and limits.svg.
void write_limits(const std::filesystem::path& folder, const LimitsFacts& limits);

}  // namespace dmp::cli
