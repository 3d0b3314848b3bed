// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Checks that involve several keys: names, references, keys that require or exclude others. `document` supplies the
/// locations of tables. Throws InputError.
void check_scene(const Scene& scene, const TomlNode& document);

/// Sets defaults to 0 that the scene's choices exclude: density diffusion with density = "summation", shifting with a
/// transport velocity.
void switch_off_what_gives_way(Scene& scene);

}  // namespace dmp::scene
