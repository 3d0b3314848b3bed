// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::cli {

inline constexpr const char* sweep_results_name = "results.csv";
inline constexpr const char* sweep_timing_name = "timing.csv";

/// One run of a study that has ended, a row of results.csv.
struct SweepRow {
    struct Result {
        double value = 0;
        std::string unit;
    };
    std::string run;
    std::vector<std::string> values;  ///< of the keys that vary
    std::vector<Result> results;      ///< empty of a run that failed
    int exit_code = 0;
    std::string error;

    [[nodiscard]] bool failed() const { return !error.empty(); }
};

/// The row of a run that has reached its end: its measures.csv, reduced. A result that cannot be had is the row's
/// error.
[[nodiscard]] SweepRow finished_row(const study::Study& study, const study::Point& point,
                                    const std::filesystem::path& folder);
/// The row of a run that has failed, with the error that its output ends with.
[[nodiscard]] SweepRow failed_row(const study::Point& point, int exit_code, const std::string& output);

/// The last error in what a run has said, on one line: the line that begins with "error:", else the last one.
[[nodiscard]] std::string last_error(const std::string& output);

/// What is told of a run that a signal has ended.
[[nodiscard]] std::string killed_text(int signal);

/// An error on one line, "FILE:1:2: what is wrong".
[[nodiscard]] std::string one_line(const Error& error);

/// Of a run that failed earlier, as results.csv has it.
struct EarlierFailure {
    int exit_code = 0;
    std::string error;
};

/// Those in an earlier results.csv, by the name of the run; none where there is no such file.
[[nodiscard]] std::map<std::string, EarlierFailure> earlier_failures(const std::filesystem::path& file);

/// What a run took, by timing.csv: all its starts together.
struct RunTime {
    double wall_s = 0, processor_s = 0;
};

/// Those in a timing.csv, by the name of the run; none where there is no such file.
[[nodiscard]] std::map<std::string, RunTime> run_times(const std::filesystem::path& file);

/// All rows of a study.
class SweepTable {
  public:
    SweepTable(const study::Study& study, std::size_t runs) : study_(study), rows_(runs) {}

    void set(std::size_t index, SweepRow row) { rows_[index] = std::move(row); }
    /// A result in another unit than that of the first run that has it is its row's error.
    [[nodiscard]] std::vector<std::optional<SweepRow>> rows() const;
    /// As it was set; none: the run has not ended.
    [[nodiscard]] const std::optional<SweepRow>& row(std::size_t index) const { return rows_[index]; }

    /// results.csv: a line for each run that has ended, in the order of the study. Numbers as in measures.csv; units of
    /// results stand in the heading as soon as one run has been finished. A result in another unit is left out.
    [[nodiscard]] std::string text() const;

  private:
    /// Of each result; "" as long as no run has it.
    [[nodiscard]] std::vector<std::string> units() const;

    const study::Study& study_;
    std::vector<std::optional<SweepRow>> rows_;
};

}  // namespace dmp::cli
