// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dmp::cli {

/// How far a study is.
struct SweepCounts {
    std::size_t runs = 0;  ///< all that were asked for
    std::size_t done = 0;  ///< that have reached their end, earlier or now
    std::size_t failed = 0;
    std::size_t running = 0;

    [[nodiscard]] std::size_t left() const { return runs - done - failed; }
};

/// Wall time until the last run has ended [s], where those that ended took `mean` seconds each, the ones that run have
/// done so for the times in `running` [s], and `waiting` more will be started, `jobs` at a time. Infinite where mean is
/// 0: none has ended yet.
[[nodiscard]] double seconds_left(double mean, const std::vector<double>& running, std::size_t waiting, int jobs);

/// " 34 %  31 of 100 done, 2 running, 3 failed  2 h 3 min left"
[[nodiscard]] std::string progress_text(const SweepCounts& counts, double seconds_left);

/// Whether a line is due where there is no terminal: every two minutes.
class LineEvery {
  public:
    static constexpr double seconds = 120;

    /// After `wall` seconds.
    [[nodiscard]] bool is_due(double wall);

  private:
    double next_ = seconds;
};

}  // namespace dmp::cli
