// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace dmp::cli {

/// Where the shell would find a program of this name; "": nowhere.
[[nodiscard]] std::string program_path(const std::string& name);

/// What a program said, and how it ended.
struct ProgramOutput {
    int exit_code = 0;  ///< 128 and the signal's number where a signal ended it
    std::string output, errors;
};

/// Runs another program to its end; it reads nothing, and a Ctrl-C at the terminal does not reach it. `words`: its name
/// or path, and its arguments. Throws ResourceError where it cannot be started.
[[nodiscard]] ProgramOutput output_of(std::vector<std::string> words);

}  // namespace dmp::cli
