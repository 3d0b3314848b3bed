// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Check that regions are boxes, that residence times have one, and that each measure can be taken in the scene. Throw
/// InputError with the key's location.
void check_regions(const Scene& scene, const TomlNode& document);
void check_measures(const Scene& scene);

/// Throws InputError if the region is given and the scene has none of that name; `what` is the key and whose it is, for
/// the message.
void need_region(const Scene& scene, const Value<std::string>& region, const std::string& what);

}  // namespace dmp::scene
