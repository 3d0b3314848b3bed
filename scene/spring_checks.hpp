// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Whether each springs part says once what it is made of: in the plane a strip, in space a material. Throws
/// InputError.
void check_elastic(const Scene& scene);

}  // namespace dmp::scene
