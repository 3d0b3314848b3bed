// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/errors.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// The error for a checkpoint whose seal is whole but which holds what no run writes.
[[nodiscard]] InputError unlike_any_run(const std::string& problem);

/// The whole number that a double of a checkpoint stands for, from `low` to `end` - 1. Throws unlike_any_run, which
/// calls it `what`, where it is none of these.
[[nodiscard]] std::int64_t loaded_whole(double value, std::int64_t low, std::int64_t end, const std::string& what);

/// Throws it, likewise, where one of the numbers is not finite.
void check_finite(std::span<const double> values, const std::string& what);

/// Throws it where the owned particles of loaded groups cannot be of a run with ids from 0 to `ids` - 1 and so many
/// parts: another id or part, a number that is not finite.
void check_loaded(std::span<const ParticleGroup> groups, std::int64_t ids, std::size_t parts);

}  // namespace dmp::solver
