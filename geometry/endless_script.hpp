// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/script_tokens.hpp"

namespace dmp::geometry {

/// Throws InputError, with its place, for what would keep gmsh busy without end or fill the memory, as far as that can
/// be told without running the script: a list {1 : 1e12}, loops of more rounds than any geometry takes, a macro that
/// always calls itself. `files` are the names that tokens count. What depends on values that the script works out is
/// left to the limits of time and memory.
void check_that_it_ends(const std::vector<ScriptToken>& tokens, const std::vector<std::string>& files);

}  // namespace dmp::geometry
