// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace dmp::cli {

/// Runs the action and returns its exit code, or prints what it throws to stderr and returns the code for that.
/// The one place where errors become exit codes.
int exit_code_of(const std::function<int()>& action);

/// An error as a person reads it: "error: WHERE: WHAT" and what to do, indented.
std::string error_text(const std::string& where, const std::string& problem, const std::string& what_to_do,
                       bool colour);

}  // namespace dmp::cli
