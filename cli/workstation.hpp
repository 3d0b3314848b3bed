// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/diagnosis.hpp"
#include "cli/particles_with_origin.hpp"
#include "cli/uses.hpp"
#include "postproc/pictures.hpp"
#include "scene/scene.hpp"
#include "solver/results/frame.hpp"
#include "solver/results/frame_source.hpp"
#include "solver/results/run_label.hpp"

namespace dmp::cli {

// What dmp does with gmsh, CGAL and VTK, which a cluster need not have. workstation.cpp does it; in builds for clusters
// cluster.cpp stands in its place and says what to do instead. The commands 'mesh' and 'convert' go the same way.

/// The particles that a scene's geometry asks for. Throws InputError.
[[nodiscard]] ParticlesWithOrigin particles_from_geometry(const Scene& scene, const GeometryReading& reading);

/// Whether the process that reads geometries can be confined here (docs/security.md); empty: there is none.
[[nodiscard]] std::optional<Finding> geometry_confinement();

/// Frames as ParaView opens them. Throws InputError when the folder cannot be made or written to.
[[nodiscard]] std::unique_ptr<FrameSeries> paraview_frames(const std::filesystem::path& folder, const RunLabel& label);

/// Those that a run's folder has; null: this dmp cannot read them. Throws InputError where a list of them is damaged.
[[nodiscard]] std::unique_ptr<FrameSource> stored_paraview_frames(const std::filesystem::path& folder);

/// Pictures of a run that left ParaView's files.
[[nodiscard]] Pictures draw_pictures(const std::filesystem::path& folder, const PictureOptions& options);

}  // namespace dmp::cli
