// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/run_label.hpp"
#include "solver/simulation.hpp"

namespace dmp::postproc {

inline constexpr const char* measures_file_name = "measures.csv";
inline constexpr const char* summary_file_name = "summary.json";

/// folder/measures.csv: "time [s],inlet_flux [m^2/s],..." and a line for each row. Numbers are the shortest text that
/// reads back as the same double; missing values are "nan". Throws ResourceError when the disk does not take it,
/// std::invalid_argument when names, units and rows do not fit together.
void write_measures_csv(const std::filesystem::path& folder, const MeasureSeries& measures);

/// The series back from folder/measures.csv. Throws InputError with file and line when it is missing or malformed.
MeasureSeries read_measures_csv(const std::filesystem::path& folder);

/// What summary.json says beyond the solver's own summary.
struct SummaryExtra {
    RunLabel label;
    std::vector<std::string> files;  ///< what the run left, relative to the folder
};

/// folder/summary.json, what scripts want of a run (keys: docs of `RunSummary`). NaN and infinities become null.
/// A measure's `last` is its last row; min, max and mean are over its finite rows, `missing` counts the others.
/// Throws ResourceError when the disk does not take it.
void write_summary(const std::filesystem::path& folder, const RunSummary& summary, const SummaryExtra& extra);

}  // namespace dmp::postproc
