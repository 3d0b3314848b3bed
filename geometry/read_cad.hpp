// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// The geometry of the CAD file (STEP, IGES, BREP) that gmsh has open, with lengths of STEP and IGES in millimetres.
/// Bodies of one name are one solid; bodies without a name are solid_1, solid_2, ..., and one that is alone has the
/// file's name. Faces with a name are surface sets; a file without bodies is one surface set. Faces without bodies that
/// lie in z = 0 make a geometry in 2-D: areas, named as bodies are (area_1, ...), and curves: edges with a name of
/// their own, and those that bound no face (curve_1, ...). Throws InputError: a BREP file, and no unit in the options;
/// a file without faces; bodies that are not closed; areas that are none.
Geometry read_open_cad(const GeometryOptions& asked);

}  // namespace dmp::geometry
