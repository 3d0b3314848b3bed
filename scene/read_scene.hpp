// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace dmp::scene {

/// Reads and checks a scene. `path` is a scene file or a folder with a scene.toml.
/// `overrides` are "key=value" texts as given to --set: `particles.spacing="0.1 mm"`, `part.leaflets.enabled=false`
/// (an entry of a list is selected by its name); a value that is not a TOML value is read as text, because shells
/// remove quotes.
/// Throws InputError with file:line:column (for an override: "--set KEY=VALUE").
Scene read_scene(const std::string& path, std::span<const std::string> overrides = {});

/// Output of `dmp explain KEY`: the key's meaning, type, unit, range and default.
/// Throws InputError with a suggestion for an unknown key.
std::string explain_key(const std::string& key);

/// Origin of the value of a key that the scene does not give: "default", or the scene's quality and its location.
std::string default_origin(const Scene& scene, const std::string& key);

/// All keys of a scene with their defaults as a Markdown table.
std::string scene_reference();

/// The pages of docs/scene/: an index and one page for each table of a scene, "top" for the keys before the first
/// table.
std::vector<std::string> reference_tables();
std::string reference_index();
/// Throws std::out_of_range for an unknown table.
std::string reference_page(const std::string& table);

/// The scene with all defaults filled in, as TOML in SI units; it is written beside the results.
std::string resolved_scene(const Scene& scene);

/// Reads a quantity such as "0.2 s" of the dimension of `expected_unit` ("s"), in SI units. Throws InputError.
double read_quantity(const std::string& text, const std::string& expected_unit, const SourceLocation& location = {});

}  // namespace dmp::scene
