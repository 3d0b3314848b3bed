// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/sweep/sweep_runs.hpp"
#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// What a run of so many particles and frames leaves on the disk [bytes], roughly.
[[nodiscard]] double disk_of_run(std::size_t particles, double frames, bool pictures, const study::LeftOut& left_out);

/// The first runs and their values as a table, with units above.
[[nodiscard]] std::string runs_text(const study::Study& study, const study::Points& points,
                                    const std::vector<std::size_t>& chosen);

/// What the runs take by the first one: its particles are made and its first steps timed. `costs`: of each chosen run,
/// as a multiple of that of the first.
[[nodiscard]] std::string cost_text(const study::Study& study, const study::Points& points,
                                    const std::vector<std::size_t>& chosen, const std::vector<double>& costs,
                                    const SweepSettings& settings);

}  // namespace dmp::cli
