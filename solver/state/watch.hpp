// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "solver/time/fluid_step.hpp"

namespace dmp {

/// Watches a run and says, as soon as it leaves the region where its equations hold, which particle did and why.
class Watch {
  public:
    Watch(const ParticleSet& set, double sound_speed, double support)
        : set_(set), sound_speed_(sound_speed), support_(support) {}

    struct Finding {
        std::string problem;     ///< the first bad particle: id, part, place, speed, the limit it broke
        std::string what_to_do;  ///< the likely cause
    };

    /// Empty while all is well. `extremes` are those of the step just done; positions are looked at as well.
    [[nodiscard]] std::optional<Finding> look(const ParticleStore& particles, const FluidExtremes& extremes) const;

    /// Fluid particles that lie behind the surface of their nearest wall particle by more than a spacing, or outside
    /// the box: they have left the domain.
    [[nodiscard]] std::size_t lost(const ParticleStore& particles, const ClusterList& list) const;

  private:
    [[nodiscard]] Finding describe(const ParticleStore& particles, int i, const std::string& limit) const;
    [[nodiscard]] bool outside_box(const ParticleStore& particles, int i) const;

    const ParticleSet& set_;
    double sound_speed_;
    double support_;
};

}  // namespace dmp
