// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::cli {

/// What people call the scene: its folder's name for a scene.toml, else the file's name without its ending.
[[nodiscard]] std::string scene_name(const Scene& scene);

}  // namespace dmp::cli
