// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What is odd about a scene with this many spring bodies, though it can run.
std::vector<Warning> warnings_of(const Scene& scene, std::size_t bodies);

}  // namespace dmp::solver
