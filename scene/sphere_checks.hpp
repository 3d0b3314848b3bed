// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Checks spheres, their walls and contacts: positions and mass are given once, and each pair of parts that can touch
/// has a contact law with the damping and friction that it needs. Throws InputError.
void check_spheres(const Scene& scene, const TomlNode& document);

/// Throws InputError for a measure of spheres in a scene without them, another measure in a scene with them, or a
/// measure of a part that does not exist.
void check_sphere_measure(const Scene& scene, const Measure& measure);

}  // namespace dmp::scene
