// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Writes "key=value" texts, as given to --set, into the scene's document; later ones override earlier ones. An entry
/// of a list is selected by its name: `part.leaflets.enabled=false`; `measure.NAME.kind=...` adds a measure. The
/// location of such a value is "--set KEY=VALUE". Throws InputError for a text without '=', an unknown key, or a list
/// entry that is not in the document.
void apply_overrides(TomlNode& document, std::span<const std::string> overrides);

/// The key of a "key=value" text as given to --set.
std::string key_of_override(const std::string& text);

/// A key as --set takes it, "part.leaflets.density", in words. Throws InputError at `location` where the schema has no
/// such key, or where it does not say of which entry of a list it is.
std::vector<std::string> words_of_key(const std::string& key, const SourceLocation& location);

/// Whether a key adds an entry to a list with these names: the kind of a measure does, unless its name is nearly that
/// of another.
bool adds_entry(const std::string& list, const std::string& name, const std::string& key,
                const std::vector<std::string>& names);

/// The error for an entry that the list does not have; `names` are those that it has.
InputError no_such_entry(const std::string& list, const std::string& name, const std::vector<std::string>& names,
                         const SourceLocation& location);

}  // namespace dmp::scene
