// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace dmp::cli {

/// How far a study is.
struct SweepCounts {
    std::size_t runs = 0;  ///< all that were asked for
    std::size_t done = 0;  ///< that have reached their end, earlier or now
    std::size_t failed = 0;
    std::size_t running = 0;
    std::size_t ended_now = 0;  ///< that were started by this process and have ended, also those that failed

    [[nodiscard]] std::size_t left() const { return runs - done - failed; }
};

/// Wall time until the last run has ended, as the runs so far took `wall` seconds [s]; infinite before the first end.
[[nodiscard]] double seconds_left(const SweepCounts& counts, double wall);

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
