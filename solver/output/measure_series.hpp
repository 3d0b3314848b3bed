// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/results/frame.hpp"
#include "solver/state/archive.hpp"

namespace dmp::solver {

/// A series of measures on its way into a checkpoint or out of one; its columns are those of the scene. A column that
/// the checkpoint does not have is NaN in the rows from there; one that the scene no longer asks for is left out.
void archive_series(Archive& file, MeasureSeries& series);

}  // namespace dmp::solver
