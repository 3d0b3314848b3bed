// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/particles_with_origin.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::cli {

/// The values of a scene that its particles depend on, "part.leaflets.bending_stiffness = ..." each. The geometry
/// itself is not among them, nor is where it lies.
[[nodiscard]] std::vector<std::string> values_behind_particles(const Scene& scene);

/// The particles in a file that 'dmp mesh --particles' wrote. Throws InputError: no such file, damaged, or made for
/// another scene, with what differs.
[[nodiscard]] ParticlesWithOrigin particles_from_file(const std::filesystem::path& file, const Scene& scene);

}  // namespace dmp::cli
