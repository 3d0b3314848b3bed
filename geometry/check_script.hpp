// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/errors.hpp"
#include "geometry/script_tokens.hpp"

namespace dmp::geometry {

/// Throws InputError, with file, line and word, for a script that would do something besides describing shapes: run a
/// program, write or read a file, ask the network, set gmsh's commands and file names. What may follow what is looked
/// at on the tokens, so that neither comments nor line breaks hide anything. `files` are the names that tokens count.
///
/// It holds for gmsh's parser only with the text that CheckedScript makes of the tokens: gmsh passes over statements
/// and jumps back to lines by counting characters, which texts and comments of a script as it was written can mislead.
void check_script(const std::vector<ScriptToken>& tokens, const std::vector<std::string>& files);

/// The error for a word that would do harm; where: the word's.
[[nodiscard]] InputError harm_in_script(const SourceLocation& where, const std::string& word, const std::string& harm);

}  // namespace dmp::geometry
