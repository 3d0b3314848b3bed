// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Whether each elastic solid says once what it is made of: in 2-D a strip, in 3-D a material. Throws
/// InputError.
void check_elastic(const Scene& scene);

}  // namespace dmp::scene
