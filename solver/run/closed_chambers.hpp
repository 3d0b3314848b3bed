// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Whether the fluid consists of several chambers (neighbours/chambers.hpp), or may do so later: elastic bodies that
/// can move may open and close ways between them, as may liquid that turns solid.
bool may_have_chambers(const Scene& scene, const ParticleSet& set);

}  // namespace dmp::solver
