// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/spheres/sphere_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Follows a scene's measures of spheres over time.
///   largest_speed   [m/s]
///   kinetic_energy  of translation and rotation [J]
///   velocity, spin  of a part: the mean of its spheres, three columns each [m/s], [rad/s]
///   wall_force      of all walls on spheres, three columns [N]
///   detached        how many spheres hang together with the part of one sphere no more, three columns: of all, of
///   those
///                   that were drawn on the half of it that the direction points to (upper), of the others (lower)
class SphereMeasures {
  public:
    SphereMeasures(const Scene& scene, const ParticleSet& set, const Ranks& ranks);

    /// Adds a row. All ranks together.
    void take(double time, const SphereStep& step);
    [[nodiscard]] const MeasureSeries& series() const { return series_; }
    void archive(Archive& file);

  private:
    struct Rows;

    [[nodiscard]] std::vector<double> detached(const Measure& measure, const SphereStep& step) const;
    /// Mean of a vector over the spheres of the measure's part.
    [[nodiscard]] std::vector<double> mean_of(const Measure& measure, const SphereStep& step,
                                              Row SphereMotion::*quantity) const;

    std::vector<Measure> measures_;
    ParticleSpace space_;
    std::vector<Vec> initial_;  ///< places at the start by id
    std::vector<int> part_of_id_;
    const Ranks& ranks_;
    MeasureSeries series_;
};

}  // namespace dmp::solver
