// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp::postproc {

inline constexpr const char* paraview_script_name = "open_in_paraview.py";

/// A Python script for ParaView 5.11 and later that opens the series in its folder: particles as discs with a radius
/// of half the spacing [m], the fluid coloured by speed, bonds as tubes, walls in grey. It still works after the
/// folder has been moved.
std::string paraview_script(double spacing);

}  // namespace dmp::postproc
