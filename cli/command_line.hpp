// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace dmp::cli {

/// Does what a command line asks for: the name that dmp is called by, and its arguments. Returns the exit code; what
/// goes wrong is said.
int do_command_line(std::span<const char* const> words);

}  // namespace dmp::cli
