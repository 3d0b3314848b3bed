// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace dmp::scene {

/// Reads and checks a scene. `path` is a scene file or a folder with a scene.toml in it.
/// `overrides` are "key=value" texts as given to --set: `particles.spacing="0.1 mm"`, `part.leaflets.enabled=false`
/// (a part or measure is addressed by its name); a value that is no TOML value is taken as text, so the shell's
/// missing quotes do no harm.
/// Throws InputError with file:line:column (for an override: "--set KEY=VALUE").
Scene read_scene(const std::string& path, std::span<const std::string> overrides = {});

/// What `dmp explain KEY` prints: the key's type, unit, range, default and meaning.
/// Throws InputError with the nearest right key for an unknown one.
std::string explain_key(const std::string& key);

/// Where the value of a key that the scene does not give comes from: "default", or the scene's quality and its place.
std::string default_origin(const Scene& scene, const std::string& key);

/// Every scene key with its default as a Markdown table, one row each.
std::string scene_reference();

/// The pages of docs/scene/: an index and one page for each table of a scene, "top" for the keys before the first.
std::vector<std::string> reference_tables();
std::string reference_index();
/// Throws std::out_of_range for a table that no scene has.
std::string reference_page(const std::string& table);

/// The scene with every default filled in, as TOML in SI units; written beside the results.
std::string resolved_scene(const Scene& scene);

/// Reads "0.2 s", "3e-3 m/s" ... of the dimension of `expected_unit` ("s", "m/s"); throws InputError.
double read_quantity(const std::string& text, const std::string& expected_unit, const SourceLocation& location = {});

}  // namespace dmp::scene
