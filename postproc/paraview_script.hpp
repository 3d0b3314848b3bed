// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp::postproc {

inline constexpr const char* paraview_script_name = "open_in_paraview.py";

/// A Python script for ParaView 5.11 and later that opens the series in its folder: a view for each of speed, stress,
/// concentrations and residence times that the frames hold, with one camera. Particles are discs, in 3-D balls, of half
/// the spacing [m] or so; bonds are tubes; walls are grey, in 3-D cut open. A field has one range of colours for all
/// times, from 0 to what a thousandth of the particles exceeds in one of five frames. The script still works after the
/// folder has been moved.
std::string paraview_script(double spacing);

}  // namespace dmp::postproc
