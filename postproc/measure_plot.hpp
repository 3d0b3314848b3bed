// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postproc/canvas.hpp"
#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"

namespace dmp::postproc {

/// One panel per measure over a common time axis, `width` pixels wide, or narrower if more than a hundred measures
/// would exceed the largest height of a canvas. Missing values leave a gap in the curve. The series must have at
/// least one measure and one row.
Canvas draw_measures(const MeasureSeries& measures, const std::string& title, int width);

}  // namespace dmp::postproc
