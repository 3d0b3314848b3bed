// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Checks that involve several keys: names, references, keys that require or exclude others. `document` supplies the
/// locations of tables. Throws InputError.
void check_scene(const Scene& scene, const TomlNode& document);

/// The first known location, otherwise the scene file.
SourceLocation first_known(const Scene& scene, std::initializer_list<const SourceLocation*> places);

}  // namespace dmp::scene
