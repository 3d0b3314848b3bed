// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Checks between keys: names, references, what one key asks of another. `document` tells where things stand.
/// Throws InputError.
void check_scene(const Scene& scene, const TomlNode& document);

/// Sets defaults to 0 that stand against what the scene asks for: density diffusion beside summed densities, shifting
/// beside a transport velocity.
void switch_off_what_gives_way(Scene& scene);

}  // namespace dmp::scene
