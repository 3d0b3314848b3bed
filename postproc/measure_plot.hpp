// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postproc/canvas.hpp"
#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"

namespace dmp::postproc {

/// One panel a measure over a common time axis, `width` pixels wide; narrower where more than a hundred measures would
/// be taller than a canvas can be. Missing values leave a gap in the curve. The series must hold a measure and a row.
Canvas draw_measures(const MeasureSeries& measures, const std::string& title, int width);

}  // namespace dmp::postproc
