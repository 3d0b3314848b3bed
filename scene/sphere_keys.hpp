// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// Rows of the schema for parts of kind spheres, plane and surface.
std::vector<Key<Part>> sphere_part_keys();

/// Rows of the schema for [[contact_pair]].
std::vector<Key<ContactPair>> contact_pair_keys();

}  // namespace dmp::scene
