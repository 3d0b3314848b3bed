// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp::solver {

/// Identifies the run in each of its files.
struct RunLabel {
    std::string title;       ///< of the scene
    std::string scene_hash;  ///< of the resolved scene, 16 hex digits
    std::string version;     ///< of dmp
};

}  // namespace dmp::solver
