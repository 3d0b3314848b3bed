// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// The schema's rows of [[species]], [[region]] and [[measure]]: what is followed.
std::vector<Key<Species>> species_keys();
std::vector<Key<ResidenceRegion>> region_keys();
std::vector<Key<Measure>> measure_keys();

}  // namespace dmp::scene
