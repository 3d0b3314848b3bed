// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"

#include <variant>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/failure.hpp"

namespace dmp::cli {

int do_command_line(std::span<const char* const> words) {
    return exit_code_of([&] {
        const Command command = read_arguments(words);
        return std::visit([](const auto& chosen) { return execute(chosen); }, command);
    });
}

}  // namespace dmp::cli
