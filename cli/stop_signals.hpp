// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace dmp::cli {

/// From now on a signal that ends dmp (Ctrl-C, SIGTERM, the end of the terminal) first removes the lock that it holds.
/// Signals that whoever started dmp has switched off (nohup) stay so.
void remove_lock_on_signals();

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
