// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "cli/typed_command.hpp"
#include "cli/uses.hpp"
#include "report/study_facts.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// Writes into the folder of a study what its page says of it besides the runs: study.json, and the command in
/// sweep.log. Throws ResourceError.
void begin_sweep_page(const std::filesystem::path& folder, const study::Study& study, const study::Points& points,
                      const TypedCommand& typed);

/// Writes the page of the study in the folder, of what is there now. Returns a line for the listing of results, "" with
/// a warning where it cannot be written: of runs that are done, that is no error.
std::string write_sweep_page(const std::filesystem::path& folder, const study::Study& study,
                             const study::Points& points);

/// What study.json holds. Of results whose unit is known only once a run has ended, `results_csv` (may be "") has it.
[[nodiscard]] StudyFacts study_facts(const study::Study& study, const study::Points& points,
                                     const std::string& results_csv);

}  // namespace dmp::cli
