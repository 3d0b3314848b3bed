// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_rows.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/output_folder.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// A table of thousands of rows is not written anew for each run that takes less than this [s].
constexpr double seconds_between_tables = 1;
constexpr std::size_t most_failures_told = 10;

}  // namespace

SweepRows::SweepRows(const study::Study& study, const study::Points& points, const SweepFolder& folder,
                     std::vector<std::size_t> chosen)
    : study_(study), points_(points), folder_(folder), chosen_(std::move(chosen)), table_(study, points.size()) {
    counts_.runs = chosen_.size();
    if (const fs::path timing = folder.path() / sweep_timing_name; !fs::exists(timing))
        write_file(timing, "run,wall_time [s],processor_time [s],peak_memory [B],exit_code\n");
}

std::vector<std::size_t> SweepRows::take_earlier_ends(
    const std::function<bool(std::size_t, const fs::path&)>& is_held) {
    const std::map<std::string, EarlierFailure> failures = earlier_failures(folder_.path() / sweep_results_name);
    std::vector<bool> chosen(points_.size(), false);
    for (const std::size_t index : chosen_) chosen[index] = true;
    std::vector<std::size_t> unfinished;
    for (std::size_t index = 0; index < points_.size(); ++index) {
        const study::Point point = points_.at(index);
        const fs::path run = run_folder(folder_.path(), point.name);
        const bool finished = contents_of(run).kind == FolderContents::Kind::finished;
        if (!chosen[index]) {
            // The table has also the runs that were not asked for now.
            if (finished)
                table_.set(index, finished_row(study_, point, run));
            else if (const auto failure = failures.find(point.name); failure != failures.end())
                table_.set(index, failed_row(point, failure->second.exit_code, failure->second.error));
        } else if (finished && !is_held(index, run)) {
            static_cast<void>(add(index, finished_row(study_, point, run)));
        } else {
            unfinished.push_back(index);
        }
    }
    return unfinished;
}

std::string SweepRows::add(std::size_t index, SweepRow row) {
    std::string text;
    if (row.failed()) {
        ++counts_.failed;
        if (counts_.failed <= most_failures_told) text = "run " + row.run + " failed: " + row.error;
        if (counts_.failed == most_failures_told)
            text += fmt::format("\nMore of them are told in {} only.", sweep_results_name);
    } else {
        ++counts_.done;
    }
    table_.set(index, std::move(row));
    changed_ = true;
    return text;
}

void SweepRows::write(bool at_once) {
    if (!changed_ || (!at_once && seconds_since(written_) < seconds_between_tables)) return;
    write_file(folder_.path() / sweep_results_name, table_.text());
    written_ = WallClock::now();
    changed_ = false;
}

void SweepRows::count_other_units() {
    const auto rows = table_.rows();
    for (const std::size_t index : chosen_) {
        if (!rows[index] || rows[index]->failed() == table_.row(index)->failed()) continue;
        ++counts_.failed;
        --counts_.done;
    }
}

void SweepRows::note_time(const std::string& run, double wall_s, double processor_s, double peak_memory,
                          int exit_code) const {
    append_to_file(folder_.path() / sweep_timing_name,
                   fmt::format("{},{:.3f},{:.3f},{:.0f},{}\n", run, wall_s, processor_s, peak_memory, exit_code));
}

}  // namespace dmp::cli
