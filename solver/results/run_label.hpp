// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp::solver {

/// What every file says of the run it belongs to.
struct RunLabel {
    std::string title;       ///< of the scene
    std::string scene_hash;  ///< of the resolved scene, 16 hex digits
    std::string version;     ///< of dmp
};

}  // namespace dmp::solver
