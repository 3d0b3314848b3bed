// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace dmp::cli {

/// While it lives, the first Ctrl-C or SIGTERM asks the run to stop after its step; a second one ends dmp at once.
class StopSignals {
  public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// For RunOptions::stop.
    [[nodiscard]] const std::atomic<bool>& flag() const;
    /// The exit code that goes with the signal that came.
    [[nodiscard]] int exit_code() const;
};

}  // namespace dmp::cli
