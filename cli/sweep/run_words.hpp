// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/run_output.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// How a run of a study is started.
struct RunWords {
    std::vector<std::string> words;  ///< the command line
    std::string note;                ///< what to tell of the run's checkpoint; "": nothing
};

/// What each of so many runs of a study leaves out: what the study says, else by their number.
[[nodiscard]] study::LeftOut left_out_of(const study::Study& study, std::size_t runs);

/// The command line of a run, without what says how to begin. `folder`: of the study; `program`: the name that dmp is
/// called by; `threads`: of each rank; `left_out`: what the run does not write.
[[nodiscard]] std::vector<std::string> run_line(const study::Study& study, const study::Point& point,
                                                const std::filesystem::path& folder, const std::string& program,
                                                int threads, const study::LeftOut& left_out);

/// The same, which goes on from the run's checkpoint, or from the start where it has none that is good.
[[nodiscard]] RunWords words_for_run(const study::Study& study, const study::Point& point,
                                     const std::filesystem::path& folder, const std::string& program, int threads,
                                     const study::LeftOut& left_out);

}  // namespace dmp::cli
