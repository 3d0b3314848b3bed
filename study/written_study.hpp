// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "study/run_output.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// A study that dmp writes itself: a value of each key for each run.
struct WrittenStudy {
    std::string comment;  ///< by whom, and what for; one line
    std::string title, purpose;
    std::string scene;                                                          ///< its path
    LeftOut left_out{RunOutput::frames, RunOutput::pictures, RunOutput::page};  ///< by the runs
    std::vector<std::pair<std::string, std::vector<std::string>>> columns;      ///< keys and their values, as TOML
};

/// "key" of "key=value", as given to --set.
[[nodiscard]] std::string key_set_by(const std::string& assignment);

/// What `overrides` set, as TOML, by key; of a key that is given twice the last one. Without run.threads, which are not
/// a run's own.
[[nodiscard]] std::map<std::string, std::string> values_set(const std::vector<std::string>& overrides);

/// Its file, in `folder`.
[[nodiscard]] std::string study_text(const WrittenStudy& study, const std::filesystem::path& folder);

}  // namespace dmp::study
