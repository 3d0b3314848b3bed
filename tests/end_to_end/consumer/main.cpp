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
    const dmp::Scene scene = dmp::read_scene(argv[1]);
    dmp::GeometryOptions drawing;
    drawing.file = scene.directory + "/" + *scene.geometry.file;
    for (const auto& [name, value] : scene.geometry.parameters) drawing.parameters[name] = value;
    dmp::MeshResult made = dmp::mesh(dmp::read_geometry(drawing), scene);
    const std::size_t count = made.particles.size();
    dmp::VtkSink sink(argv[3], {"consumer", scene.hash, "installed"});
    dmp::Simulation simulation(scene, std::move(made.particles), 1);
    dmp::RunOptions options;
    options.until = dmp::read_quantity(argv[2], "s");
    options.sink = &sink;
    std::cout << count << " particles, " << simulation.run(options).lost << " lost\n";
}
