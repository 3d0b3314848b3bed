// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// The schema's rows of [[join]].
std::vector<Key<Join>> join_keys();

/// Whether each [[join]] is of parts that bonds can join: elastic solids, or one and a rigid part that rests. Throws
/// InputError.
void check_joins(const Scene& scene);

}  // namespace dmp::scene
