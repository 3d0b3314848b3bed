// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "cli/uses.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp::cli {

/// Runs the action and returns its exit code, or prints what it throws to stderr and returns the code for that.
/// The one place where errors become exit codes.
int exit_code_of(const std::function<int()>& action);

/// Does the action on every rank of a run. An error of any of them ends them all, with the exit code that goes with it.
int on_all_ranks(const MpiSession& session, const std::function<int()>& action);

/// An error as a person reads it: "error: WHERE: WHAT" and what to do, indented.
std::string error_text(const std::string& where, const std::string& problem, const std::string& what_to_do,
                       bool colour);

}  // namespace dmp::cli
