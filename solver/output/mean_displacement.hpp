// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/elastic/spring_bodies.hpp"

namespace dmp::solver {

/// Time average of the displacement of each node of the spring bodies, from output.average_from on:
///   <u> = SUM u dt / SUM dt   [m]
/// over the steps that end later. Before that it is the displacement of the moment. Kept only when
/// output.solid_fields names mean_displacement. Every rank has all of it, as it has all bodies.
class MeanDisplacement {
  public:
    MeanDisplacement(const Scene& scene, const SpringBodies& springs);

    /// After the step from `time` to `time` + dt [s].
    void add(const SpringBodies& springs, double time, double dt);
    /// Of a node of a body [m].
    [[nodiscard]] Vec of(const SpringBodies& springs, std::size_t body, std::size_t node) const;
    void archive(Archive& file);

  private:
    double from_;                                         ///< [s]
    double duration_ = 0;                                 ///< so far [s]
    std::vector<std::vector<Vector<double, 3>>> moment_;  ///< SUM u dt by body and node [m s]; empty: not wanted
};

}  // namespace dmp::solver
