// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp::postproc {

inline constexpr const char* paraview_script_name = "open_in_paraview.py";

/// A Python script for ParaView 5.11 and later that opens the series beside it: particles as discs of half the
/// spacing [m], the fluid coloured by speed, bonds as tubes, walls in grey. It works after the folder has moved.
std::string paraview_script(double spacing);

}  // namespace dmp::postproc
