// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "scene/scene.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/plan.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Looks for voids that open in a fluid that has no free surface at the start, by the particles beside them
/// (models/sph/void_closing.hpp). Densities follow the flow and say nothing of voids: they stay those of a liquid while
/// a solid that moves away leaves space that no particle can fill.
class VoidMonitor {
  public:
    struct Settings {
        bool watches;  ///< only with the corrected scheme, and not where the fluid has a free surface at the start
        bool closes;   ///< suction acts on voids
    };
    VoidMonitor(const Scene& scene, const Settings& settings) : scene_(scene), settings_(settings) {}

    /// Whether the state after this step is one of those to look at: the more seldom, the longer the run.
    [[nodiscard]] static bool wants(std::int64_t step) {
        return step % std::clamp<std::int64_t>(step / 10, 1, 100) == 0;
    }
    /// Looks at the state at time t [s], until there has been a void: then it returns the warning. All ranks take part.
    /// @param is_known whether suction says that there is one, or was in this step
    std::optional<Warning> look(const ParticleStore& particles, const Ranks& ranks, double t, bool is_known = false);

    /// "a void opened in the fluid by 1.2 s, at particle 12 of 'blood' at (...)"; "" where there was none.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::optional<Warning> warning() const;

    void archive(Archive& file);

  private:
    const Scene& scene_;
    Settings settings_;
    std::int64_t particle_ = -1;     ///< at the first void, the one with the largest correction; -1: there was none
    std::string part_;               ///< that it belongs to
    double time_ = 0;                ///< [s]
    std::array<double, 3> place_{};  ///< [m]
};

}  // namespace dmp::solver
