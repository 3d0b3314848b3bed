// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/commands.hpp"
#include "cli/particles_with_origin.hpp"
#include "cli/uses.hpp"
#include "geometry/geometry.hpp"
#include "mesher/inspect.hpp"
#include "mesher/mesh.hpp"

namespace dmp::cli {

/// Reads a geometry; what others' programs parse in a process of its own, which is this program once more.
[[nodiscard]] Geometry answer_geometry_request_command(GeometryOptions options, const GeometryReading& reading);

/// From a scene's geometry, or its spheres, to particles and the report on them. Throws InputError.
[[nodiscard]] MeshResult mesh_geometry(const Scene& scene, const GeometryReading& reading);

/// The same with a closer look at the particles, which takes longer.
[[nodiscard]] MeshResult mesh_geometry(const Scene& scene, const GeometryReading& reading, MeshDetail& detail);

/// What of the report a run says before it starts.
[[nodiscard]] Origin origin_of(const Scene& scene, const MeshReport& report);

}  // namespace dmp::cli
