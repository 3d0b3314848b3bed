// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/vec.hpp"

namespace dmp::postproc {

/// From where particles are looked at: of what is seen, x runs to the right, y up and z towards the eye.
struct Viewpoint {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< a row each: to the right, up, towards the eye
    Vec origin = Vec::Zero();                            ///< what is seen at (0, 0, 0) [m]

    [[nodiscard]] Vec operator()(const Vec& position) const { return axes * (position - origin); }
    /// The box around a box as it is seen.
    [[nodiscard]] Box operator()(const Box& box) const;
};

/// With these two of the axes x, y and z (0, 1, 2) to the right and up.
Viewpoint along(int right, int up, const Vec& origin = Vec::Zero());

/// The same, from a little further right and above.
Viewpoint aslant(const Viewpoint& front);

/// Where a slice across an axis lies and how it is seen: "y right, z up, at x = 2.5 mm". `scale` chooses the
/// prefix [m].
std::string slice_text(int right, int up, const Vec& origin, double scale);

}  // namespace dmp::postproc
