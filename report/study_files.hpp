// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/limits_facts.hpp"
#include "report/picture.hpp"
#include "report/run_files.hpp"
#include "report/study_facts.hpp"
#include "report/trade_facts.hpp"

namespace dmp::report {

/// A run of a study that has ended, as results.csv has it.
struct StudyRow {
    std::string run;
    std::vector<std::string> values;  ///< of the keys
    std::vector<double> results;      ///< NaN where it has none
    int exit_code = 0;
    std::string error;  ///< "": it did not fail
    bool has_page = false;

    [[nodiscard]] bool failed() const { return !error.empty(); }
};

/// Of all starts of runs, as timing.csv has them; NaN where that does not say.
struct StudyTiming {
    std::size_t starts = 0;
    double wall_s = 0, processor_s = 0;  ///< of all together [s]
    double longest_s = 0;                ///< of one start [s]
    std::string longest_run;
    double peak_memory = 0;  ///< the largest [bytes]
};

/// A picture of a run.
struct RunPicture {
    std::size_t row = 0;
    Picture picture;
};

/// What a study left in its folder.
struct StudyFiles {
    std::filesystem::path folder;
    StudyFacts facts;
    LoggedRun log;  ///< of sweep.log: each time that it was started
    std::vector<StudyRow> rows;
    std::vector<std::string> result_units;
    StudyTiming timing;
    std::vector<RunPicture> pictures;
    std::size_t pictures_left_out = 0;
    std::string study_text, scene_text;  ///< its file and its scene's
    std::optional<TradeFacts> trade;     ///< of a study that is a trade, once two of its runs can be compared
    std::optional<LimitsFacts> limits;   ///< of a study of limits, once its scene has run with its own settings
    std::vector<std::string> notes;      ///< files that are not there, or cannot be shown

    [[nodiscard]] std::size_t failed() const;
};

/// The most pictures of runs on a page, and what they may take [bytes].
inline constexpr std::size_t most_run_pictures = 24, most_run_picture_bytes = 2'000'000;

inline constexpr const char* study_log_name = "sweep.log";

/// Throws InputError where the folder or its study.json is missing, or a table, trade.json or limits.json is damaged.
[[nodiscard]] StudyFiles read_study_files(const std::filesystem::path& folder);

}  // namespace dmp::report
