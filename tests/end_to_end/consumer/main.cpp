// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "geometry/geometry.hpp"
#include "mesher/mesh.hpp"
#include "postproc/vtk_sink.hpp"
#include "scene/read_scene.hpp"
#include "solver/simulation.hpp"

/// Runs a scene for the time given and prints the number of particles.
int main(int argc, char** argv) {
    if (argc != 4) return 2;
    const dmp::scene::Scene scene = dmp::scene::read_scene(argv[1]);
    dmp::geometry::GeometryOptions cad_file;
    cad_file.file = scene.directory + "/" + *scene.geometry.file;
    for (const auto& [name, value] : scene.geometry.parameters) cad_file.parameters[name] = value;
    dmp::mesher::MeshResult made = dmp::mesher::mesh(dmp::geometry::read_geometry(cad_file), scene);
    const std::size_t count = made.particles.size();
    dmp::postproc::VtkSink sink(argv[3], {"consumer", scene.hash, "installed"});
    dmp::solver::Simulation simulation(scene, std::move(made.particles), 1);
    dmp::solver::RunOptions options;
    options.until = dmp::scene::read_quantity(argv[2], "s");
    options.sink = &sink;
    std::cout << count << " particles, " << simulation.run(options).lost << " lost\n";
}
