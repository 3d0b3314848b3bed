// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/wall_clock.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_progress.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// The table of a study while its runs come to their ends, wherever they are done, and how far it is.
class SweepRows {
  public:
    /// `chosen`: indices of the runs that were asked for, in order.
    SweepRows(const study::Study& study, const study::Points& points, const SweepFolder& folder,
              std::vector<std::size_t> chosen);

    /// Takes the runs that have ended before this process has begun: they are in the table from its first line on.
    /// Returns the chosen ones that are not finished, in order; `is_held`: whether another process writes one's folder.
    [[nodiscard]] std::vector<std::size_t> take_earlier_ends(
        const std::function<bool(std::size_t, const std::filesystem::path&)>& is_held);

    /// A run has ended. Returns what is to be said of it; "": nothing.
    [[nodiscard]] std::string add(std::size_t index, SweepRow row);
    /// Writes results.csv if it has changed; unless `at_once`, not more often than every second.
    void write(bool at_once);
    /// To be called when all rows are there: a result in another unit is seen then.
    void count_other_units();
    /// A line of timing.csv.
    void note_time(const std::string& run, double wall_s, double processor_s, double peak_memory, int exit_code) const;

    [[nodiscard]] const study::Study& study() const { return study_; }
    [[nodiscard]] const study::Points& points() const { return points_; }
    [[nodiscard]] const SweepFolder& folder() const { return folder_; }
    [[nodiscard]] const std::vector<std::size_t>& chosen() const { return chosen_; }
    [[nodiscard]] const SweepTable& table() const { return table_; }
    [[nodiscard]] SweepCounts& counts() { return counts_; }
    [[nodiscard]] const SweepCounts& counts() const { return counts_; }

  private:
    const study::Study& study_;
    const study::Points& points_;
    const SweepFolder& folder_;
    std::vector<std::size_t> chosen_;
    SweepTable table_;
    SweepCounts counts_;
    WallClock::time_point written_ = WallClock::now();
    bool changed_ = true;  ///< the table, since it was written
};

}  // namespace dmp::cli
