// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Checks of spheres, their walls and contacts: one way to place them, one mass, a law for each two parts that can
/// touch, damping and friction where it needs them. Throws InputError.
void check_spheres(const Scene& scene, const TomlNode& document);

/// Throws InputError where a measure of spheres is asked for without them, or another one with them; or its part is
/// none.
void check_sphere_measure(const Scene& scene, const Measure& measure);

}  // namespace dmp::scene
