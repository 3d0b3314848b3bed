// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// Rows of the schema for [[reference]].
std::vector<Key<Reference>> reference_keys();

}  // namespace dmp::scene
