// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace dmp::mesher {

/// The whole number of cells next to this many, at least one. A half counts up, also where rounding has left a little
/// less of it: curves that are drawn alike get the same number wherever they stand.
[[nodiscard]] inline double whole_cells(double cells) { return std::max(1.0, std::floor(cells + 0.5 + 1e-6)); }

}  // namespace dmp::mesher
