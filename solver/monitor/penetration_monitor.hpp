// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/neighbours/cluster_list.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/results/plan.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

class SurfaceContact;

/// Looks for particles of elastic solids that have passed into another solid: those more than half a spacing behind the
/// surface of a wall or of another body, or nearer than 0.4 spacings to one of its particles (0.57 of a short range).
/// Contact keeps them in front of it. Particles nearer
/// than 1.2 spacings to a wall at the start, as where a solid is held, do not count, nor do those that are in another
/// solid then. Where bodies change, pieces of one part are not told from each other, and torn bodies have no surface.
/// Where bodies touch as their surfaces, those say it instead (SurfaceContact::deepest).
class PenetrationMonitor {
  public:
    /// @param strength of the contact's repulsion [J]
    PenetrationMonitor(const Scene& scene, double strength) : scene_(scene), strength_(strength) {}

    /// Whether the state after this step is one of those to look at.
    [[nodiscard]] static bool wants(std::int64_t step) { return step % 50 == 0; }
    /// Notes what is beside another part at the start of a run. All ranks take part.
    void start(const ParticleStore& particles, const ClusterList& list, const Ranks& ranks);
    /// Looks at the state at time t [s], until something has passed into a solid: then it returns the warning. All
    /// ranks take part. @param list as of positions near those of now
    /// @param surfaces where they touch, in place of particles: then what they say counts
    std::optional<Warning> look(const ParticleStore& particles, const ClusterList& list, const SurfaceContact* surfaces,
                                const Ranks& ranks, double t);

    [[nodiscard]] std::optional<Warning> warning(const SurfaceContact* surfaces) const;

    /// What start() noted, which belongs to the state.
    void archive_start(Archive& file);
    /// What was found.
    void archive(Archive& file);

  private:
    [[nodiscard]] double strength_by_material() const;
    void give_advice(Warning& warning, const SurfaceContact* surfaces) const;

    const Scene& scene_;
    double strength_;                ///< [J]
    std::vector<double> beside_;     ///< ids of particles that do not count, ascending
    std::int64_t particle_ = -1;     ///< the deepest at the first look that found any; -1: none, or surfaces
    std::string part_, other_;       ///< that it belongs to, and that it is in; empty: there was none
    double time_ = 0;                ///< [s]
    double depth_ = 0;               ///< behind the surface; 0: not known [m]
    double distance_ = 0;            ///< from the nearest particle there [m]
    std::array<double, 3> place_{};  ///< [m]
};

}  // namespace dmp::solver
