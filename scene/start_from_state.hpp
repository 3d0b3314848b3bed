// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "scene/scene_difference.hpp"

namespace dmp::scene {

/// A value that a run which starts from the state of another one must share with it.
struct FixedValue {
    ValueDifference difference;
    std::string why;  ///< a clause
};

/// Of what differs between the resolved scene `before`, of the run whose state is taken over, and `scene`: the values
/// that must be the same. Others may change: what drives the scene, viscosities, stiffness and damping of elastic
/// solids (not where bodies change during the run, whose springs are part of the state), lengths of steps and
/// tolerances, and what is written and measured. A key that is not known to be one of these must be the same.
[[nodiscard]] std::vector<FixedValue> fixed_in_start(const std::string& before, const Scene& scene);

/// The first five, a line each: "\n  particles.spacing: was "0.5 mm", is "0.4 mm": the particles would be others".
[[nodiscard]] std::string fixed_text(const std::vector<FixedValue>& fixed);

}  // namespace dmp::scene
