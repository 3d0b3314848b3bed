// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/prepare.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

/// The physics-changing values in force, which of them the scene gave and which dmp chose: sound speed, kernel, walls,
/// time step with its ruling limit, spring constants, and what was adapted when the particles were made.
[[nodiscard]] Listing chosen_values(const Scene& scene, const Plan& plan, const Origin& origin);
/// The same of a scene of spheres: the law of each pair of parts, with its defaults.
[[nodiscard]] Listing chosen_values_of_spheres(const Scene& scene, const Plan& plan, const Origin& origin);
/// Those values below a heading.
[[nodiscard]] std::string chosen_text(const Listing& values);

/// Every limit of the time step with its formula, the ruling one marked.
[[nodiscard]] std::string limits_text(const Plan& plan);

}  // namespace dmp::cli
