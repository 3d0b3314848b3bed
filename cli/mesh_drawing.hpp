// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/prepare.hpp"
#include "mesher/inspect.hpp"

namespace dmp::cli {

/// From a scene's drawing, or its spheres, to particles and the report on them. Throws InputError.
[[nodiscard]] MeshResult mesh_drawing(const Scene& scene);

/// The same with a closer look at the particles, which takes longer.
[[nodiscard]] MeshResult mesh_drawing(const Scene& scene, MeshDetail& detail);

/// What of the report a run says before it starts.
[[nodiscard]] Origin origin_of(const Scene& scene, const MeshReport& report);

}  // namespace dmp::cli
