// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <span>

#include "base/allocation.hpp"
#include "cli/command_line.hpp"

int main(int argc, char** argv) {
    // A file past the size limit is then an error that says so, and not the end of the process.
    std::signal(SIGXFSZ, SIG_IGN);
    dmp::return_large_arrays();
    return dmp::cli::do_command_line(std::span<const char* const>(argv, static_cast<std::size_t>(argc)));
}
