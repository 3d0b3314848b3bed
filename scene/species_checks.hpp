// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Throws InputError where species, what they are given by part, and what is asked of them do not fit together.
void check_species(const Scene& scene);

}  // namespace dmp::scene
