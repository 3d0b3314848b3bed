// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Throws InputError if species, their values by part, and the measures of them are inconsistent.
void check_species(const Scene& scene);

}  // namespace dmp::scene
