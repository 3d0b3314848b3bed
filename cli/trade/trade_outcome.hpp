// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/sweep/sweep_table.hpp"
#include "cli/trade/given_reference.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "study/points.hpp"
#include "study/trade_errors.hpp"
#include "study/trade_settings.hpp"

namespace dmp::cli {

/// The folder that `dmp trade` writes a scene's trade into where none is given.
[[nodiscard]] std::filesystem::path default_trade_folder(const Scene& scene);

/// What the runs of a trade are compared by.
struct TradeComparison {
    std::vector<std::string> measures;        ///< names of the scene's measures; empty: all
    std::optional<GivenReference> reference;  ///< none: the finest run
};

/// What a trade has found, of the runs that have ended.
struct TradeOutcome {
    std::string scene_path;           ///< as given
    std::string scene_name;           ///< for people
    std::string identity;             ///< study::trade_identity of it
    std::vector<std::string> common;  ///< what is set in all runs, "key=value", besides the duration
    double until = 0, duration = 0;   ///< of the runs of the trade, and of the scene [s]
    study::TradeSettings settings;
    std::vector<std::string> names;     ///< of the run of each setting
    std::vector<std::string> failures;  ///< of each setting; "": it has not failed
    std::vector<bool> begun;            ///< each setting: its run was stopped, and can go on
    std::vector<std::string> columns;   ///< of measures.csv, which are compared
    std::vector<std::string> units;     ///< of those
    std::vector<study::TradeRun> runs;  ///< that have ended
    study::TradeErrors errors;          ///< where two of them or more are no repeats

    /// Whether a setting may be advised: it is a candidate, and no lower level than the scene's own where the runs do
    /// not go on to the scene's end, as what it does later has not been seen.
    [[nodiscard]] bool may_be_advised(const study::TradeSetting& setting) const;
    /// Enough to compare.
    [[nodiscard]] bool is_known() const { return !errors.runs.empty(); }
    [[nodiscard]] const study::TradeSetting& setting(const study::TradeRun& run) const {
        return settings.settings[run.setting];
    }
    /// Indices of the runs that no other beats in cost and error, cheapest first.
    [[nodiscard]] std::vector<std::size_t> front() const;
};

/// Of the runs in the folder of a trade. A run whose table of measures is damaged has failed. Throws InputError where
/// one of the measures to compare has no column that all runs have.
[[nodiscard]] TradeOutcome trade_outcome(const std::filesystem::path& folder, const Scene& scene,
                                         const study::TradeSettings& settings, const study::Points& points,
                                         const TradeComparison& comparison);

/// For people: the table of settings, what is known of the measures, and for each tolerance the cheapest setting.
[[nodiscard]] std::string trade_text(const TradeOutcome& outcome, const std::vector<double>& tolerances,
                                     const std::string& program);

/// Where the runs of a trade do not go on to the end of the scene: " up to 1.2 s of 4 s".
[[nodiscard]] std::string compared_time_text(double until, double duration);

/// trade.json and trade.svg.
void write_trade(const std::filesystem::path& folder, const TradeOutcome& outcome);

}  // namespace dmp::cli
