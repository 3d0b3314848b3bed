// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/results/plan.hpp"

namespace dmp::cli {

/// Throws InputError where a run until this time [s] would write more than a million frames, or more than a hundred
/// million rows of measures: a value is mistyped, and disks or years do not suffice. To be called before particles are
/// made.
void check_frames(const Scene& scene, double until);

/// Throws InputError where the run would take more than 1e12 steps, which are 12 days at a microsecond each: it names
/// the limit that rules them.
void check_steps(const Scene& scene, const Plan& plan, double until);

/// Where frames are due more often than steps: that they rule the steps. None: they do not.
[[nodiscard]] std::optional<Warning> frames_rule_steps(const Scene& scene, const Plan& plan);

}  // namespace dmp::cli
