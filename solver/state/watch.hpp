// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "solver/time/fluid_step.hpp"

namespace dmp {

/// Watches a run and says, as soon as it leaves the region where its equations hold, which particle did and why.
class Watch {
  public:
    /// Rest densities by part number [kg/m^3]; the scene is for naming likely causes.
    Watch(const Scene& scene, const ParticleSpace& space, std::vector<double> rest_density, double sound_speed,
          double support)
        : scene_(scene),
          space_(space),
          rest_density_(std::move(rest_density)),
          sound_speed_(sound_speed),
          support_(support) {}

    struct Finding {
        std::string problem;     ///< the first bad particle: id, part, place, speed, the limit it broke
        std::string what_to_do;  ///< the likely cause
    };

    /// Empty while all is well with this rank's particles. `extremes` are those of the step just done; positions are
    /// looked at as well.
    [[nodiscard]] std::optional<Finding> look(const ParticleStore& particles, const FluidExtremes& extremes) const;

    /// This rank's fluid particles that lie behind the surface of their nearest wall particle by more than a spacing,
    /// or outside the box: they have left the domain.
    [[nodiscard]] std::size_t lost(const ParticleStore& particles, const ClusterList& list) const;

  private:
    [[nodiscard]] std::optional<Finding> worst_of_fluid(const ParticleGroup& fluid) const;
    [[nodiscard]] Finding describe(const ParticleGroup& group, std::size_t i, const std::string& limit) const;
    [[nodiscard]] std::string likely_causes(const ParticleGroup& group, bool left) const;
    [[nodiscard]] bool outside_box(const ParticleGroup& group, std::size_t i) const;

    const Scene& scene_;
    ParticleSpace space_;
    std::vector<double> rest_density_;
    double sound_speed_;
    double support_;
};

}  // namespace dmp
