// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// What the run of a setting is for.
enum class TradeRole {
    candidate,  ///< it may be advised
    repeat,     ///< of the scene's own setting, for the scatter: spacing and step are a little different
    reference   ///< given by the user, to compare all others with
};

/// What trades accuracy for speed at one spacing: a level of quality, or, in a scene that gives its speed of sound, a
/// lower one.
struct TradeLevel {
    std::string text;  ///< "draft", "sound speed 1.5 m/s"
    double rank = 0;   ///< the higher, the more accurate
};

/// A setting of a scene's resolution and level, whose cost and error a trade measures.
struct TradeSetting {
    double spacing = 0;        ///< of the particles [m]; 0: the scene has none
    std::string spacing_text;  ///< "0.1414 mm"; "": the scene has none
    TradeLevel level;
    TradeRole role = TradeRole::candidate;
    double cost = 1;                  ///< expected, as a multiple of that of the scene's own spacing and level
    std::vector<std::string> values;  ///< of the trade's keys, as TOML
};

/// The settings that a trade compares: spacings of 2, sqrt(2), 1 and 1 / sqrt(2) times the scene's own, each with the
/// quality levels that differ in this scene, and two repeats.
struct TradeSettings {
    std::vector<std::string> keys;       ///< that differ, as --set names them
    std::vector<TradeSetting> settings;  ///< cheapest first
    TradeLevel own_level;                ///< of the scene

    /// Whether they set the key of "key=value".
    [[nodiscard]] bool sets(const std::string& assignment) const;
    /// Expected, as multiples of that of the first one.
    [[nodiscard]] std::vector<double> costs() const;
    /// What makes a run of the scene this setting, as --set takes it; without what its level sets. Nothing for a
    /// reference.
    [[nodiscard]] std::vector<std::string> overrides(const TradeSetting& setting) const;
};

/// What all runs of a trade have in common.
struct TradeScene {
    std::string path;                    ///< a scene file, or a folder with a scene.toml
    std::vector<std::string> overrides;  ///< of the scene, "key=value", as given to --set
};

/// A length with its unit: "0.1414 mm".
[[nodiscard]] std::string spacing_text(double length);

/// The level that a run of the scene has; `as_run`: the scene with the run's values.
[[nodiscard]] TradeLevel level_of(const Scene& as_run, const Scene& scene);

/// Throws InputError where the scene cannot be read.
[[nodiscard]] TradeSettings trade_settings(const TradeScene& scene);

/// A hash of all that costs and errors depend on besides the settings, 16 hex digits: of the scene, but not of
/// what they set, its duration, title, threads and output. Throws InputError likewise.
[[nodiscard]] std::string trade_identity(const TradeScene& scene);

/// The study that runs them in this order, for a file in `folder`.
[[nodiscard]] std::string trade_study(const TradeScene& scene, const TradeSettings& settings,
                                      const std::filesystem::path& folder);

}  // namespace dmp::study
