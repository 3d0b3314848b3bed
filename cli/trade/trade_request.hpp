// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/trade/trade_outcome.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "study/trade_settings.hpp"

namespace dmp::cli {

/// A trade as it was asked for.
struct TradeRequest {
    study::TradeScene scene;         ///< with what is set in all runs
    Scene read;                      ///< that scene
    std::string identity;            ///< of the scene as it was given
    double duration = 0;             ///< of the scene without --until [s]
    std::optional<double> budget;    ///< [s]
    std::vector<double> tolerances;  ///< in rising order
    std::vector<std::string> added;  ///< measures that the scene has not got, and the trade adds
    TradeComparison comparison;
    study::TradeSettings settings;
};

/// Of a scene without measures, conserved ones are added: its kinetic energy, and the amount of its one
/// species. Throws
/// InputError where an option cannot have its value, or there are not two settings to compare.
[[nodiscard]] TradeRequest trade_request(const TradeCommand& command);

/// For a dry run: the settings, with their costs as multiples of the scene's own.
[[nodiscard]] std::string settings_text(const study::TradeSettings& settings);

}  // namespace dmp::cli
