// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "cli/uses.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

/// Guesses how long is left from how fast time advanced, recent progress counting most.
class TimeLeft {
  public:
    /// After `wall` seconds the simulation stands at `time` of `until` [s].
    void update(double wall, double time, double until);
    /// [s]; infinite before there is anything to go by.
    [[nodiscard]] double seconds() const;

  private:
    double wall_ = 0, time_ = 0, until_ = 0;
    double rate_ = 0;    ///< simulated seconds a second, averaged over recent progress
    double weight_ = 0;  ///< how much is known of it, in [0, 1]
};

/// "  42 %   1.68 s of 4 s   20 512 steps   0.081 m/s at most   43 frames   2 min 31 s left"
[[nodiscard]] std::string progress_text(const RunProgress& progress, double seconds_left);

/// One line on stderr that overwrites itself; nothing at all when that is no terminal.
class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const RunProgress& progress);
    void show(const std::string& text);
    void clear();

  private:
    bool on_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point start_;
    TimeLeft left_;
};

}  // namespace dmp::cli
