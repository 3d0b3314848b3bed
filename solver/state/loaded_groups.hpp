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

/// Throws it where the owned particles of loaded groups cannot be of a run with ids from 0 to `ids` - 1 and so many
/// parts: another id or part, a number that is not finite.
void check_loaded(std::span<const ParticleGroup> groups, std::int64_t ids, std::size_t parts);

}  // namespace dmp::solver
