// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What is odd about a scene with this many spring bodies, though it can run.
std::vector<Warning> warnings_of(const Scene& scene, std::size_t bodies);

/// Says that implicit viscosity would take about a tenth of the time, or less: where the viscous limit is the shortest
/// of these, 200 times shorter than any other (docs/speed.md, "Implicit viscosity").
std::optional<Warning> viscosity_better_implicit(const Scene& scene, const std::vector<StepLimit>& limits);

/// Says that liquids of unlike density, under this largest acceleration [m/s^2], are stirred at their interface by the
/// scheme itself, where sqrt(A g dx^3) / nu exceeds 3 with A = (rho_max - rho_min) / (rho_max + rho_min) and the least
/// nu (docs/scheme.md, "Limits that are known"); with the plain scheme, where one is more than ten times as dense.
std::optional<Warning> stirred_interface(const Scene& scene, double acceleration);

}  // namespace dmp::solver
