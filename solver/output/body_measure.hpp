// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// An elastic solid, or all that a [[solidify]] has made, as one body. With sums over its particles, X and x from the
/// centres of mass in the initial and in the present state, the mean deformation is the F that fits best (least
/// squares, by mass):
///   F = (SUM m x (x) X) (SUM m X (x) X)^-1 = R U
///   angle     of the turn R [rad]: in 2-D anticlockwise, over any number of turns if it turns by less than half a one
///             between two rows; in 3-D 0 to pi
///   length    extent of the particles' centres along the longest principal axis of SUM m x (x) x [m]
///   stretches least and largest principal value of U [-]; 1 along a direction in which the body has no extent
/// What turned solid has no initial state, as it did so one particle after another: its angle and stretches are NaN.
/// Every rank has all of it, as it has all bodies.
class BodyMeasure {
  public:
    BodyMeasure(const Scene& scene, const Measure& measure, const SpringBodies& springs);

    /// Throws InputError for a solid that goes on through a periodic side: it has no middle and no ends.
    static void need_ends(const Measure& measure, const ParticleSet& set);

    /// Centre of mass and velocity, by component, angle, length, least and largest stretch; NaN where nothing has
    /// turned solid. `angle_before`: in the row before [rad].
    [[nodiscard]] std::vector<double> values(double angle_before) const;

  private:
    int dimension_;
    bool is_there_ = false, has_initial_state_;
    Vec centre_ = Vec::Zero(), velocity_ = Vec::Zero();
    double length_ = 0;
    Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity(), stretch_ = Eigen::Matrix3d::Identity();  ///< R and U
};

}  // namespace dmp::solver
