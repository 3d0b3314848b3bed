// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workstation.hpp"

#include <fmt/format.h>

#include "cli/mesh_cache.hpp"
#include "cli/mesh_geometry.hpp"
#include "cli/uses.hpp"
#include "geometry/confinement.hpp"
#include "postproc/vtk_frames.hpp"
#include "postproc/vtk_sink.hpp"

namespace dmp::cli {

std::string workstation_libraries() { return "VTK " DMP_VTK_VERSION ", gmsh " DMP_GMSH_VERSION; }

ParticlesWithOrigin particles_from_geometry(const Scene& scene, const GeometryReading& reading) {
    const auto make = [&]() -> ParticlesWithOrigin {
        MeshResult result = mesh_geometry(scene, reading);
        return {std::move(result.particles), origin_of(scene, result.report)};
    };
    if (reading.trusted) return make();  // its script may read files that the cache does not know of
    const MeshCache cache;
    if (auto found = cache.find(scene)) return std::move(*found);
    return cache.make(scene, make);
}

std::optional<Finding> geometry_confinement() {
    const Confinement offered = confinement_offered();
    const std::string what = "CAD reading";
    const std::string files = fmt::format("opens no file but the geometry (Landlock {})", offered.files);
    if (offered.system_calls && offered.files > 0)
        return Finding{Health::ok, what, "in a process that starts no program, writes no file (seccomp) and " + files};
    std::string found = "words that do more than describe shapes are refused";
    if (offered.system_calls) {
        found = "in a process that starts no program and writes no file (seccomp), but could read others";
    } else if (offered.files > 0) {
        found = "in a process that " + files + ", but could start programs";
    }
    return Finding{Health::warn, what, found,
                   "The kernel or this build lacks the rest: open geometries of strangers on another machine "
                   "(docs/security.md)."};
}

std::unique_ptr<FrameSeries> paraview_frames(const std::filesystem::path& folder, const RunLabel& label) {
    return std::make_unique<VtkSink>(folder, label);
}

std::unique_ptr<FrameSource> stored_paraview_frames(const std::filesystem::path& folder) {
    return std::make_unique<VtkFrames>(folder);
}

Pictures draw_pictures(const std::filesystem::path& folder, const PictureOptions& options) {
    return write_pictures(folder, options);
}

}  // namespace dmp::cli
