// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/json_value.hpp"
#include "report/study_files.hpp"

namespace dmp::report {

/// The plots of a study for study_plots.js (study_data). A plot of a key or result that the study does not have is left
/// out.
[[nodiscard]] JsonValue::Json plots_json(const StudyFiles& study);

/// The section of the plots, which scripts draw.
[[nodiscard]] std::string study_plots_section(const StudyFiles& study);

}  // namespace dmp::report
