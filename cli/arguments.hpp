// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cli/commands.hpp"

namespace dmp::cli {

/// What the command line asks for; argv[0] is the name dmp was called by.
/// Throws InputError: unknown command or option (with the nearest name), missing or malformed value.
Command read_arguments(std::span<const char* const> argv);

}  // namespace dmp::cli
