// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Checks that each [[reference]] is for one column of a measure, with one formula or file, and that a formula has the
/// column's dimension and finite values. Files are read later (study::ExactValues). Throws InputError.
void check_references(const Scene& scene);

}  // namespace dmp::scene
