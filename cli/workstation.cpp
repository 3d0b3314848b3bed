// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workstation.hpp"

#include "cli/mesh_cache.hpp"
#include "cli/mesh_geometry.hpp"
#include "cli/uses.hpp"
#include "postproc/vtk_sink.hpp"

namespace dmp::cli {

std::string workstation_libraries() { return "VTK " DMP_VTK_VERSION ", gmsh " DMP_GMSH_VERSION; }

ParticlesWithOrigin particles_from_geometry(const Scene& scene) {
    const MeshCache cache;
    if (auto found = cache.find(scene)) return std::move(*found);
    return cache.make(scene, [&]() -> ParticlesWithOrigin {
        MeshResult result = mesh_geometry(scene);
        return {std::move(result.particles), origin_of(scene, result.report)};
    });
}

std::unique_ptr<FrameSeries> paraview_frames(const std::filesystem::path& folder, const RunLabel& label) {
    return std::make_unique<VtkSink>(folder, label);
}

Pictures draw_pictures(const std::filesystem::path& folder, const PictureOptions& options) {
    return write_pictures(folder, options);
}

}  // namespace dmp::cli
