// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/mesh.hpp"

namespace dmp::mesher {

/// Whether the scene is one of spheres and their walls, which has no geometry.
bool is_of_spheres(const Scene& scene);

/// Places the spheres of a scene (docs/spheres.md) and hands on their walls. Throws InputError: files that cannot be
/// read, spheres that do not fit, a part to sit on that has more than one sphere, spheres that lie in each other or in
/// a wall at the start (named, with their place).
MeshResult mesh_spheres(const Scene& scene);

}  // namespace dmp::mesher
