// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "cli/progress.hpp"
#include "cli/uses.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

inline constexpr const char* run_log_name = "run.log";

/// "step 20512, t = 1.68 of 4 s (42 %), dt 8e-05 s, at most 0.081 m/s, density -0.1 % to +0.2 %, 43 frames, 2 min 31 s
/// left"; the density where there is a fluid, what is left where it is known.
[[nodiscard]] std::string log_text(const RunProgress& progress, double seconds_left);

/// folder/NAME, run.log: what a run said, and every two minutes how far it is; one that goes on adds to it. Lines
/// without colours. The text is in the file when a call returns. Throws ResourceError.
class RunLog {
  public:
    /// Begins with the time and the command line.
    RunLog(const std::filesystem::path& folder, const std::string& command_line, const char* name = run_log_name);

    void add(const std::string& text);
    /// The same, after it was printed.
    void say(const std::string& text);
    /// The same on stderr, a line that begins with "warning"; further lines are indented.
    void warn(const std::string& text);
    /// Adds a line if one is due after `wall` seconds of running, and returns it without its end; else returns "".
    std::string progress(const RunProgress& progress, double wall);

  private:
    static constexpr double seconds_between_lines = 120;

    std::filesystem::path file_;
    TimeLeft left_;
    double next_ = seconds_between_lines;  ///< [s]
};

}  // namespace dmp::cli
