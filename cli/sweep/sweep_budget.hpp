// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/wall_clock.hpp"
#include "cli/uses.hpp"
#include "study/points.hpp"

namespace dmp::cli {

/// The wall time that the runs of a study may take, all starts together, and what they are expected to take.
class SweepBudget {
  public:
    /// `seconds`: none: any. `costs`: of each run, in any unit. `folder`: of the study, whose timing.csv says what was
    /// spent.
    SweepBudget(std::optional<double> seconds, std::vector<double> costs, const study::Points& points,
                std::filesystem::path folder, int jobs, int threads);

    /// Whether a run is expected to end within the budget, by those that have ended. What cannot be expected may start.
    [[nodiscard]] bool may_start(std::size_t index) const;
    /// When it is spent.
    [[nodiscard]] WallClock::time_point end() const;
    /// Processor time [s] that these runs are expected to take; none before any run has ended.
    [[nodiscard]] std::optional<double> expected(const std::vector<std::size_t>& runs) const;

  private:
    [[nodiscard]] double left() const;

    std::optional<double> seconds_;
    std::vector<double> costs_;
    const study::Points& points_;
    std::filesystem::path folder_;
    int threads_;
    double spent_ = 0;  ///< before this process [s]
    WallClock::time_point start_ = WallClock::now();
};

}  // namespace dmp::cli
