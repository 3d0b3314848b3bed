// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace dmp {

/// A point or vector [SI units of the quantity]; in 2-D scenes z = 0.
using Vec = Eigen::Vector3d;

/// An axis-aligned box.
struct Box {
    Vec low = Vec::Zero();
    Vec high = Vec::Zero();

    [[nodiscard]] Vec extent() const { return high - low; }
};

}  // namespace dmp
