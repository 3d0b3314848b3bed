// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// Rows of the schema for [[species]], [[region]] and [[measure]].
std::vector<Key<Species>> species_keys();
std::vector<Key<ResidenceRegion>> region_keys();
std::vector<Key<Measure>> measure_keys();

}  // namespace dmp::scene
