// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "scene/scene.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/plan.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// How coarse the particles are for the flow that came about: how much the velocity changes from one to the next,
///
///     S = dx (SUM gamma^2 / SUM |u|^2)^(1/2),    gamma^2 = 2 D : D,    D = (G + G^T) / 2
///
/// over the fluid and over time, with the velocity gradient G that the corrected scheme keeps. In steady
/// Poiseuille flow with n particles across S is about 3.2 / n. Measured errors: docs/accuracy.md, "How coarse".
class VelocityChange {
  public:
    /// Whether the state after this step is one of those to add: the more seldom, the longer the run.
    [[nodiscard]] static bool wants(std::int64_t step) {
        return step % std::clamp<std::int64_t>(step / 10, 1, 50) == 0;
    }
    /// Adds the state at time t, for the time since the one added before; all ranks together. With the plain scheme,
    /// which keeps no gradient, nothing.
    void add(const ParticleStore& particles, const Ranks& ranks, double t);

    /// Sums begin at time t.
    void start(double t) { added_until_ = t; }

    /// S; nothing where no fluid moved.
    [[nodiscard]] std::optional<double> value(double spacing) const;
    /// Above 0.4, where flows of the verification suite are off by 4 % and more.
    [[nodiscard]] std::optional<Warning> warning(const Scene& scene) const;

    void archive(Archive& file);

  private:
    double rates_ = 0, speeds_ = 0;  ///< SUM gamma^2 dt [1/s], SUM |u|^2 dt [m^2/s]
    double added_until_ = 0;         ///< [s]
};

}  // namespace dmp::solver
