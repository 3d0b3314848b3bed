// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp {

/// Checks between keys: names, references, what one key asks of another. `document` tells where things stand.
/// Throws InputError.
void check_scene(const Scene& scene, const TomlNode& document);

}  // namespace dmp
