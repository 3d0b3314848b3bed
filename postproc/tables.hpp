// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/plan.hpp"
#include "solver/results/run_label.hpp"
#include "solver/simulation.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::postproc {

inline constexpr const char* measures_file_name = "measures.csv";
inline constexpr const char* summary_file_name = "summary.json";

/// folder/measures.csv: "time [s],inlet_flux [m^2/s],..." and a line for each row. Numbers are the shortest text that
/// reads back as the same double; missing values are "nan". Throws ResourceError if the file cannot be written,
/// std::invalid_argument if the numbers of names, units and values do not match.
void write_measures_csv(const std::filesystem::path& folder, const MeasureSeries& measures);

/// Renames folder/measures.csv to the first free of measures_1.csv, measures_2.csv, ... where its columns are not those
/// of `measures`. Returns the new name, "" where there is no other table. Throws ResourceError.
std::string keep_other_measures(const std::filesystem::path& folder, const MeasureSeries& measures);

/// folder/measures.csv of a run that goes on: what has been measured is in the file whatever ends the run.
class MeasuresFile {
  public:
    explicit MeasuresFile(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The first time as write_measures_csv; then adds the rows that are new.
    void write(const MeasureSeries& measures);
    [[nodiscard]] bool is_begun() const { return rows_.has_value(); }

  private:
    std::filesystem::path folder_;
    std::optional<std::size_t> rows_;  ///< in the file; none before the first time
};

/// Reads the series from folder/measures.csv. Throws InputError with file and line if it is missing or malformed.
MeasureSeries read_measures_csv(const std::filesystem::path& folder);

/// Contents of summary.json in addition to the solver's summary.
struct SummaryExtra {
    RunLabel label;
    std::vector<std::string> files;  ///< files written by the run, relative to the folder
    std::optional<StartedFrom> started_from{};
    std::vector<std::pair<std::string, std::string>> chosen{};  ///< values in force and where they come from
    std::vector<ModelUse> models{};                             ///< that ran, and why
};

/// folder/summary.json, the results of a run for scripts (keys: docs of `RunSummary`). NaN and infinities become
/// null. A measure's `last` is its last row; min, max and mean are over its finite rows, `missing` is the number of
/// others. Throws ResourceError if the file cannot be written.
void write_summary(const std::filesystem::path& folder, const RunSummary& summary, const SummaryExtra& extra);

/// How a run ended, by its summary.json.
struct RunEnd {
    bool interrupted = false;
    double simulated_s = 0;
};

/// None if there is no summary.json or it is not one.
std::optional<RunEnd> read_run_end(const std::filesystem::path& folder);

}  // namespace dmp::postproc
