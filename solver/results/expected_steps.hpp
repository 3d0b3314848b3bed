// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Time between rows of measures [s].
[[nodiscard]] double time_between_rows(const Scene& scene);

/// Steps of at most dt [s] that a run takes until a time [s]: none goes beyond a time at which a frame or a row of
/// measures is due. Of more than can be counted the largest number.
[[nodiscard]] long expected_steps(const Scene& scene, double dt, double until);

/// Frames of a run until a time [s]: one at its start, those that are due, and one at its end.
[[nodiscard]] double expected_frames(const Scene& scene, double until);

}  // namespace dmp::solver
