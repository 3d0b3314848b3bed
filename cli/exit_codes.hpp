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
    exit_interrupted = 130,  ///< Ctrl-C, as shells count it
    exit_terminated = 143,   ///< SIGTERM
};

}  // namespace dmp::cli
