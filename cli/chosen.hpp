// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/prepare.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

/// The physics-changing values in force, which of them the scene gave and which dmp chose: sound speed, kernel, walls,
/// time step with its ruling limit, spring constants, and what was adapted when the particles were made.
[[nodiscard]] std::string chosen_text(const Scene& scene, const Plan& plan, const Origin& origin);
/// The same of a scene of spheres: the law of each pair of parts, with its defaults.
[[nodiscard]] std::string chosen_of_spheres_text(const Scene& scene, const Plan& plan, const Origin& origin);

/// Every limit of the time step with its formula, the ruling one marked.
[[nodiscard]] std::string limits_text(const Plan& plan);

}  // namespace dmp::cli
