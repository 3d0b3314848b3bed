// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/mesh.hpp"

namespace dmp::mesher {

/// Fills in kernel sums and the report's nearest distances, their histograms and kernel sums, adds the spring parts'
/// lines, and throws InputError where particles of different bodies stand on top of each other.
void measure_quality(MeshResult& result, const Scene& scene);

}  // namespace dmp::mesher
