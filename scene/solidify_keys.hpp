// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// Rows of the schema for [[solidify]] and [[break]].
std::vector<Key<Solidify>> solidify_keys();
std::vector<Key<Breaking>> breaking_keys();

}  // namespace dmp::scene
