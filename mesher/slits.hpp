// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "geometry/geometry.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// Where a cell of an area joins what is drawn apart: its box has two pieces of the area in it, each of a tenth of the
/// box or more. `area`: in the axes of the boxes. Returns the middle of the first such box, in these axes; none:
/// nowhere.
[[nodiscard]] std::optional<Vec> closed_slit(const Region& area, const BoxLattice& boxes, const SolidCells& cells);

}  // namespace dmp::mesher
