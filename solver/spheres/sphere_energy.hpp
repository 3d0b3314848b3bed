// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scene/scene.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/spheres/sphere_setup.hpp"
#include "solver/spheres/sphere_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What the contacts of all ranks' spheres store, with each other and with walls [J].
double energy_in_contacts(const SphereStep& step, const Ranks& ranks);

/// Says that energy grew by more than 1 % of the kinetic energy. Only for spheres that nothing drives.
std::optional<Warning> grown_energy(const Scene& scene, const SphereSetup& setup, const SphereEnergy& start,
                                    const SphereEnergy& end);

}  // namespace dmp::solver
