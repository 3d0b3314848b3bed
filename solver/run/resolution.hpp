// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Fluid between two surfaces of rigid parts that face each other.
struct NarrowGap {
    double width = 0;           ///< of the narrowest place [m]
    Vec place = Vec::Zero();    ///< of the fluid particle there [m]
    std::size_t particles = 0;  ///< of fluid in gaps narrower than was asked
};

/// The narrowest gap among those narrower than `width` [m] at the start. Corners are none: the surfaces must face each
/// other within 37 degrees. Gaps across a periodic boundary are not found.
std::optional<NarrowGap> narrowest_gap(const ParticleSet& set, double width);

/// Warns of what the particles are too coarse for, as it stands at the start: gaps fewer than 4.5 particles wide,
/// through which Poiseuille flow is more than 5 % off (docs/accuracy.md, "Particles across").
std::vector<Warning> resolution_warnings(const Scene& scene, const ParticleSet& set);

}  // namespace dmp::solver
