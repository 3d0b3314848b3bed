// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// Rows of the schema for [[join]].
std::vector<Key<Join>> join_keys();

/// Checks that each [[join]] names two elastic solids, or an elastic solid and a rigid part at rest. Throws InputError.
void check_joins(const Scene& scene);

}  // namespace dmp::scene
