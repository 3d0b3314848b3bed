// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dmp::cli {

/// What the shell gets to see.
enum ExitCode : int {
    exit_done = 0,
    exit_bug = 1,  ///< dmp itself is at fault
    exit_bad_input = 2,
    exit_diverged = 3,
    exit_out_of_resource = 4,
    exit_out_of_time = 5,  ///< the run has stopped at its wall-time limit, and can be resumed
    // A run that stopped at a signal, and can be resumed: 128 and the signal's number, as shells count it.
    exit_hung_up = 129,      ///< SIGHUP
    exit_interrupted = 130,  ///< Ctrl-C
    exit_user_signal = 138,  ///< SIGUSR1
    exit_no_reader = 141,    ///< SIGPIPE
    exit_terminated = 143,   ///< SIGTERM
};

}  // namespace dmp::cli
