// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/measure_columns.hpp"
#include "scene/scene.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/output/linear_fit.hpp"
#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp::solver {

/// What a fluid field is at a point: of the linear function that fits best, weighted with volume and kernel, what the
/// fluid particles within the kernel's support have. Where walls or elastic bodies hold the fluid, the velocity of
/// their surface counts as well, one sample a particle of the first row whose surface faces the point.
class Probe {
  public:
    /// All ranks together.
    Probe(const Vec& point, FluidField field, const ParticleStore& particles, const FluidStep& step,
          const PairSettings& settings, const Ranks& ranks);

    /// Whether there is fluid: a particle within 1.5 spacings.
    [[nodiscard]] bool is_in_fluid() const { return nearest_ <= 1.5 * particles_.space().spacing; }
    /// The components of probed_components of one of the field's arrays; NaN where there is no fluid. All ranks
    /// together.
    [[nodiscard]] std::vector<double> of(const FluidValues& array) const;

  private:
    struct Sample {
        std::size_t particle;
        Vec x;  ///< from the point [m]
        double weight;
    };
    struct SurfaceSample {
        Vec x;  ///< from the point [m]
        double weight;
        Vec velocity;  ///< [m/s]
    };

    void find_fluid(const Vec& point, double support);
    void find_walls(const Vec& point, double support);
    void find_bodies(const Vec& point, double support);
    void add_surface(const Vec& x, double volume, const Vec& velocity, double support);
    [[nodiscard]] Vec from_point(const ParticleGroup& group, std::size_t i, const Vec& point) const;

    const ParticleStore& particles_;
    const FluidStep& step_;
    const Ranks& ranks_;
    std::vector<Sample> fluid_;
    std::vector<SurfaceSample> surfaces_;
    double nearest_;  ///< distance of the nearest fluid particle [m]
    LinearFit fit_;
};

}  // namespace dmp::solver
