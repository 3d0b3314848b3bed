// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace dmp::cli {

/// From now on a signal that ends dmp (Ctrl-C, SIGTERM, SIGUSR1, the end of the terminal or of who reads the output)
/// first removes the lock that it holds. Signals that whoever started dmp has switched off (nohup) stay so.
void remove_lock_on_signals();

/// While it lives, the first Ctrl-C, SIGTERM, SIGUSR1 (job schedulers), SIGHUP (the terminal is gone) or SIGPIPE
/// (nobody reads the output any more: `| head`) asks the run to stop after its step. A second Ctrl-C or SIGTERM ends
/// dmp, unless it follows within half a second; more of the others change nothing, as they may come for each line that
/// is written.
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
    /// "SIGTERM"; "" before any signal.
    [[nodiscard]] const char* name() const;
};

}  // namespace dmp::cli
