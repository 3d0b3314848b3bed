// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/uses.hpp"
#include "mesher/inspect.hpp"
#include "postproc/mesh_pictures.hpp"

namespace dmp::cli {

/// Particles and what was found out about each, for write_mesh_pictures().
[[nodiscard]] MeshView mesh_view(const ParticleSet& particles, const MeshDetail& detail, const std::string& title);

}  // namespace dmp::cli
