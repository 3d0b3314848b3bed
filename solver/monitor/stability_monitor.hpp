// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "solver/time/fluid_step.hpp"

namespace dmp::solver {

/// Watches a run and says, as soon as it leaves the region where its equations hold, which particle did and why.
class StabilityMonitor {
  public:
    /// Rest densities by part number [kg/m^3]; the scene is for naming likely causes.
    StabilityMonitor(const Scene& scene, ParticleSpace space, std::vector<double> rest_density, double sound_speed,
                     double support)
        : scene_(scene),
          space_(std::move(space)),
          rest_density_(std::move(rest_density)),
          sound_speed_(sound_speed),
          support_(support) {}

    /// Walls stand this far from where they were drawn at most [m], and the fluid with them.
    void walls_have_moved(double distance) { walls_moved_ = distance; }
    /// Says which void opened in the fluid; "": none (VoidMonitor).
    void void_opened(const std::string& text) { void_ = text; }

    struct Finding {
        std::string problem;     ///< the first bad particle: id, part, place, speed, the limit it broke
        std::string what_to_do;  ///< the likely cause
    };

    /// Whether the fluid's speeds and densities are within the limits, whatever else may be wrong. Costs nothing.
    [[nodiscard]] bool fluid_is_well(const FluidExtremes& extremes) const;

    /// Empty while all is well with this rank's particles at time t [s]. `extremes` are those of the step just done;
    /// positions are looked at as well.
    [[nodiscard]] std::optional<Finding> check(const ParticleStore& particles, const FluidStep& step,
                                               const FluidExtremes& extremes, double t) const;

    /// For a spring body that could not be moved, for the reason given: this rank's fastest node, if it has any.
    [[nodiscard]] std::optional<Finding> stuck_elastic(const ParticleStore& particles, const FluidStep& step,
                                                       const std::string& reason, double t) const;

    /// This rank's fluid particles that lie behind the surface of their nearest wall particle by more than a spacing,
    /// or outside the box: they have left the domain.
    [[nodiscard]] std::size_t lost(const ParticleStore& particles, const ClusterList& list) const;

  private:
    /// What a particle was found to do.
    struct Violation {
        const ParticleGroup* group = nullptr;
        std::size_t particle = 0;
        std::string limit;   ///< the one it broke, in words
        bool left = false;   ///< the domain, while the fluid is well otherwise
        bool stuck = false;  ///< a spring body that could not be moved
    };
    [[nodiscard]] std::optional<Violation> worst_of_fluid(const ParticleGroup& fluid) const;
    [[nodiscard]] std::optional<Violation> worst_of_elastic(const ParticleGroup& springs) const;
    [[nodiscard]] std::optional<Violation> first_that_left(const ParticleStore& particles,
                                                           const ClusterList& list) const;
    [[nodiscard]] Finding describe(const Violation& violation, const ParticleStore& particles, const FluidStep& step,
                                   double t) const;
    [[nodiscard]] std::string likely_causes(const Violation& violation, const ParticleGroup& fluid,
                                            const FluidStep& step, double t) const;
    [[nodiscard]] bool outside_box(const ParticleGroup& group, std::size_t i) const;
    [[nodiscard]] double in_front_of_walls(const ParticleStore& particles, std::span<const std::int32_t> near,
                                           std::span<const std::int32_t> near_elastic, std::int32_t i) const;
    /// Calls visit(i, depth) for each of this rank's fluid particles that left, depth behind the wall's surface or 0
    /// for those outside the box, until it returns false.
    template <class Visit>
    void for_those_that_left(const ParticleStore& particles, const ClusterList& list, const Visit& visit) const;

    const Scene& scene_;
    ParticleSpace space_;
    std::vector<double> rest_density_;
    double sound_speed_;
    double support_;
    double walls_moved_ = 0;
    std::string void_;
};

}  // namespace dmp::solver
