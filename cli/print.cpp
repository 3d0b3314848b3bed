// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/terminal.hpp"

namespace dmp::cli {

int execute(const PrintCommand& command) {
    print(command.text);
    return exit_done;
}

}  // namespace dmp::cli
