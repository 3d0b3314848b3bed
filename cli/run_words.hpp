// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// How a run of a study is started.
struct RunWords {
    std::vector<std::string> words;  ///< the command line
    std::string note;                ///< what to tell of the run's checkpoint; "": nothing
};

/// Goes on from the run's checkpoint, or from the start where it has none that is good. `folder`: of the study;
/// `program`: the name that dmp is called by; `threads`: of each rank.
[[nodiscard]] RunWords words_for_run(const study::Study& study, const study::Point& point,
                                     const std::filesystem::path& folder, const std::string& program, int threads);

}  // namespace dmp::cli
