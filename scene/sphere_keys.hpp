// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// The schema's rows of spheres parts and of their walls, planes and surfaces.
std::vector<Key<Part>> sphere_part_keys();

/// The schema's rows of [[contact_pair]].
std::vector<Key<ContactPair>> contact_pair_keys();

}  // namespace dmp::scene
