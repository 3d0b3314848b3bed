// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// Which fluid of a geometry in 3-D has the room at a point, by the winding numbers of the solids: where no wall and
/// no body of springs has it, the first that holds the point.
class Vacancy {
  public:
    Vacancy(const Geometry& geometry, const Scene& scene);

    /// Its index among the scene's fluids; -1: none.
    [[nodiscard]] int fluid_at(const Vec& point) const;

  private:
    std::vector<WindingNumber> fluids_, bodies_;
};

}  // namespace dmp::mesher
