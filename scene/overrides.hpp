// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Puts "key=value" texts, as given to --set, into the scene's document; later ones win. A part or measure is addressed
/// by its name: `part.leaflets.enabled=false`. The place of such a value is "--set KEY=VALUE".
/// Throws InputError for a text without '=', an unknown key, or a part or measure the document does not have.
void apply_overrides(TomlNode& document, std::span<const std::string> overrides);

}  // namespace dmp::scene
