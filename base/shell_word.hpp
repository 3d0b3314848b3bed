// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp {

/// A word as a shell reads it back: quoted where it holds more than letters, digits and what no shell reads.
[[nodiscard]] std::string shell_word(const std::string& word);

/// A command on a file, for messages, which can be pasted: 'gmsh part.geo', and gmsh 'my part.geo' where the file's
/// name needs the quotes.
[[nodiscard]] std::string quoted_command(const std::string& command, const std::string& file);

}  // namespace dmp
