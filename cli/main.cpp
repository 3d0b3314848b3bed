// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <span>
#include <variant>

#include "base/allocation.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/failure.hpp"

int main(int argc, char** argv) {
    // A file past the size limit is then an error that says so, and not the end of the process.
    std::signal(SIGXFSZ, SIG_IGN);
    dmp::return_large_arrays();
    return dmp::cli::exit_code_of([&] {
        const auto command =
            dmp::cli::read_arguments(std::span<const char* const>(argv, static_cast<std::size_t>(argc)));
        return std::visit([](const auto& chosen) { return dmp::cli::execute(chosen); }, command);
    });
}
