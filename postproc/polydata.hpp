// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/run_label.hpp"

namespace dmp::postproc {

/// A group as VTK data: one vertex cell per particle (Threshold needs cells), then one line cell per bond, then the
/// triangles of walls for spheres.
///   points:  id, part, the group's fields in float32
///   cells:   is_bond (0 vertex, 1 bond) and the bond fields, 0 at the vertices; only in groups that have bonds
///            or are called "solid", so that a series keeps its arrays when the last bond breaks
///   field data: TimeValue, Step, spacing, part_names, title, scene_hash, dmp_version, "units:FIELD" for each field
/// Throws std::invalid_argument if an array's length does not match the number of particles or bonds.
vtkSmartPointer<vtkPolyData> to_polydata(const Frame& frame, const FrameGroup& group, const RunLabel& label);

/// The first string of a string array; empty if there is none.
std::string text_of(vtkFieldData& field_data, const std::string& name);

/// The inverse: the group, and the other values of its frame: `time`, `step`, `spacing`, `parts`, one group.
Frame to_frame(vtkPolyData& data, const std::string& group_name);

}  // namespace dmp::postproc
