// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// In place of workstation.cpp, mesh.cpp and convert.cpp where dmp is built without gmsh, CGAL and VTK.
#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "cli/workstation.hpp"

namespace dmp::cli {

namespace {

constexpr const char* only_here = "this dmp was built for clusters, without gmsh, CGAL and VTK";

[[noreturn]] void refuse(const std::string& what, const std::string& what_to_do) {
    throw InputError(std::string(only_here) + ", and " + what, what_to_do);
}

}  // namespace

std::string workstation_libraries() { return ""; }

ParticlesWithOrigin particles_from_geometry(const Scene& /*scene*/, const GeometryReading& /*reading*/) {
    refuse("cannot make particles of the scene's geometry",
           "On a workstation: dmp mesh SCENE --particles FILE.h5\n"
           "Copy the file here and add --particles FILE.h5 to this command.");
}

std::optional<Finding> geometry_confinement() { return std::nullopt; }

std::unique_ptr<FrameSeries> paraview_frames(const std::filesystem::path& /*folder*/, const RunLabel& /*label*/) {
    refuse("cannot write ParaView's files",
           "Leave out --frames vtk; on a workstation 'dmp convert DIR' makes them of the frames in HDF5.");
}

std::unique_ptr<FrameSource> stored_paraview_frames(const std::filesystem::path& /*folder*/) { return nullptr; }

/// Only a run with ParaView's files asks for pictures.
Pictures draw_pictures(const std::filesystem::path& /*folder*/, const PictureOptions& /*options*/) { return {}; }

int execute(const MeshCommand& /*command*/) {
    refuse(
        "cannot make particles of geometries",
        "Make them on a workstation, with --particles FILE.h5, and run them here: dmp run SCENE --particles FILE.h5");
}

int execute(const InspectCommand& /*command*/) {
    refuse("cannot read geometries", "Look at them on a workstation: dmp inspect FILE");
}

int execute(const NewCommand& /*command*/) {
    refuse("cannot read geometries", "Make the scene on a workstation: dmp new NAME --from FILE");
}

int execute(const ReadGeometryCommand& /*command*/) { refuse("cannot read geometries", "Do so on a workstation."); }

int execute(const ConvertCommand& /*command*/) {
    refuse("cannot write ParaView's files", "Copy the run's folder to a workstation and convert it there.");
}

}  // namespace dmp::cli
