// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/spheres/contact_job.hpp"

namespace dmp::solver {

/// Where a sphere and a wall are near each other.
struct WallTouch {
    Vector<double, 3> normal;         ///< unit vector from the wall to the sphere's centre
    double distance = 0;              ///< between them [m]
    Vector<double, 3> wall_velocity;  ///< of the surface, in the middle of the step [m/s]
};

/// What the wall does to the sphere.
struct WallPush {
    Vector<double, 3> force, torque;  ///< [N], [N m]
    double normal = 0;                ///< of the force: above 0 where it pushes [N]
};

/// One contact with a wall by one law; `history` follows it.
using WallLaw = WallPush (*)(const SphereMotion& sphere, const WallTouch& touch, const ContactConstants<double>& pair,
                             const ContactTime& time, double* history);

WallLaw wall_law(const ContactModel& model);

}  // namespace dmp::solver
