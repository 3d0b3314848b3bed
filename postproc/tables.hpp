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
inline constexpr const char* references_file_name = "references.csv";
inline constexpr const char* summary_file_name = "summary.json";

/// folder/measures.csv, or another file there: "time [s],inlet_flux [m^2/s],..." and a line for each row. Numbers are
/// the shortest text that reads back as the same double; missing values are "nan". Throws ResourceError if the file
/// cannot be written, std::invalid_argument if the numbers of names, units and values do not match.
void write_measures_csv(const std::filesystem::path& folder, const MeasureSeries& measures,
                        const std::string& name = measures_file_name);

/// Renames folder/measures.csv to the first free of measures_1.csv, measures_2.csv, ... where its columns are not those
/// of `measures`. Returns the new name, "" where there is no other table. Throws ResourceError.
std::string keep_other_measures(const std::filesystem::path& folder, const MeasureSeries& measures);

/// folder/measures.csv, or another file there, of a run that goes on: what has been measured is in the file whatever
/// ends the run.
class MeasuresFile {
  public:
    explicit MeasuresFile(std::filesystem::path folder, std::string name = measures_file_name)
        : folder_(std::move(folder)), name_(std::move(name)) {}

    /// The first time as write_measures_csv; then adds the rows that are new.
    void write(const MeasureSeries& measures);
    [[nodiscard]] bool is_begun() const { return rows_.has_value(); }

  private:
    std::filesystem::path folder_;
    std::string name_;
    std::optional<std::size_t> rows_;  ///< in the file; none before the first time
};

/// Reads the series from folder/measures.csv, or another file there. Throws InputError with file and line if it is
/// missing or malformed.
MeasureSeries read_measures_csv(const std::filesystem::path& folder, const std::string& name = measures_file_name);

/// How far a column of measures is from what the scene says that it should be (study::SeriesError); NaN: it cannot be
/// compared.
struct ReferenceDistance {
    std::string measure, column, source;  ///< `column` as in measures.csv
    double whole = 0, end = 0, peak = 0, integral = 0;
    double largest = 0;     ///< of these
    std::string why_not{};  ///< it cannot be compared
};

/// Contents of summary.json in addition to the solver's summary.
struct SummaryExtra {
    RunLabel label;
    std::vector<std::string> files;  ///< files written by the run, relative to the folder
    std::optional<StartedFrom> started_from{};
    std::vector<std::pair<std::string, std::string>> chosen{};  ///< values in force and where they come from
    std::vector<ModelUse> models{};                             ///< that ran, and why
    std::vector<ReferenceDistance> references{};
    std::vector<std::string> warnings{};  ///< given before the run's end: of the particles, of the scene, on the way
};

/// folder/summary.json, the results of a run for scripts (keys: docs of `RunSummary`). NaN and infinities become
/// null. A measure's `last` is its last row; min, max and mean are over its finite rows, `missing` is the number of
/// others. Throws ResourceError if the file cannot be written.
void write_summary(const std::filesystem::path& folder, const RunSummary& summary, const SummaryExtra& extra);

/// How a run ended, by its summary.json.
struct RunEnd {
    bool interrupted = false;
    double simulated_s = 0;
    double processor_s = 0;  ///< of its steps; 0: not known
};

/// None if there is no summary.json or it is not one.
std::optional<RunEnd> read_run_end(const std::filesystem::path& folder);

}  // namespace dmp::postproc
