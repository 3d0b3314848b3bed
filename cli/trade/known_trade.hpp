// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/commands.hpp"
#include "cli/uses.hpp"

namespace dmp::cli {

/// The cheapest setting that a trade of a scene has found for an error.
struct KnownSetting {
    SceneChoice scene;  ///< with what --set takes for it
    std::string text;   ///< what is to be told of it
};

/// `folder`: of the trade; empty: the one that `dmp trade` writes by default, or that of the scene with a trade.json.
/// Throws InputError where there is none, or it is of another scene or other values, or no setting reaches the error.
[[nodiscard]] KnownSetting known_setting(const SceneChoice& scene, const std::string& tolerance,
                                         const std::string& folder, const std::string& program);

}  // namespace dmp::cli
