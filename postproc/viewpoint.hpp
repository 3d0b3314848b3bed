// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/vec.hpp"

namespace dmp::postproc {

/// A view of the particles. In view coordinates x points to the right, y up and z towards the viewer.
struct Viewpoint {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rows: to the right, up, towards the viewer
    Vec origin = Vec::Zero();                            ///< point with view coordinates (0, 0, 0) [m]

    [[nodiscard]] Vec operator()(const Vec& position) const { return axes * (position - origin); }
    /// The bounding box of a box in view coordinates.
    [[nodiscard]] Box operator()(const Box& box) const;
};

/// The view with these two of the axes x, y and z (0, 1, 2) to the right and up.
Viewpoint along(int right, int up, const Vec& origin = Vec::Zero());

/// The oblique view: the same from slightly further right and above.
Viewpoint aslant(const Viewpoint& front);

/// Position and orientation of a slice perpendicular to an axis: "y right, z up, at x = 2.5 mm". `scale` sets the
/// prefix [m].
std::string slice_text(int right, int up, const Vec& origin, double scale);

}  // namespace dmp::postproc
