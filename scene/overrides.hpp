// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Writes "key=value" texts, as given to --set, into the scene's document; later ones override earlier ones. An entry
/// of a list is selected by its name: `part.leaflets.enabled=false`. The location of such a value is "--set KEY=VALUE".
/// Throws InputError for a text without '=', an unknown key, or a list entry that is not in the document.
void apply_overrides(TomlNode& document, std::span<const std::string> overrides);

}  // namespace dmp::scene
