// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// All rows of a study.
class SweepTable {
  public:
    SweepTable(const study::Study& study, std::size_t runs) : study_(study), rows_(runs) {}

    void set(std::size_t index, SweepRow row) { rows_[index] = std::move(row); }
    [[nodiscard]] const std::vector<std::optional<SweepRow>>& rows() const { return rows_; }

    /// results.csv: a line for each run that has ended, in the order of the study. Numbers as in measures.csv; units of
    /// results stand in the heading as soon as one run has been finished. A result in another unit than that of the
    /// first run that has it is left out, and is that row's error.
    [[nodiscard]] std::string text() const;

  private:
    /// Of each result; "" as long as no run has it.
    [[nodiscard]] std::vector<std::string> units() const;

    const study::Study& study_;
    std::vector<std::optional<SweepRow>> rows_;
};

}  // namespace dmp::cli
