// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// How fast lattices fill a body in 3-D: a ball of 81 920 triangles behind three layers of wall.
//   dmp_bench_mesh [FLUID PARTICLES] [--inspect]
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "bench/icosphere.hpp"
#include "bench/uses.hpp"
#include "cli/failure.hpp"
#include "mesher/inspect.hpp"
#include "scene/read_scene.hpp"

namespace {

using namespace dmp;
using namespace dmp::bench;

Scene scene_of(double spacing) {
    const auto file = std::filesystem::temp_directory_path() / "dmp_bench_mesh.toml";
    write_file(file,
               fmt::format("schema = 1\ndimension = 3\n[geometry]\nfile = \"none.geo\"\n[particles]\nspacing = "
                           "\"{:.17g} m\"\n[[part]]\nname = \"ball\"\nkind = \"fluid\"\ndensity = \"1 kg/m^3\"\n"
                           "viscosity = \"1 Pa*s\"\n[[part]]\nname = \"shell\"\nkind = \"rigid\"\n"
                           "[flow]\nlargest_speed = \"1 m/s\"\n[run]\nduration = \"1 s\"\n[output]\nevery = \"1 s\"\n",
                           spacing));
    Scene scene = read_scene(file.string(), {});
    std::filesystem::remove(file);
    return scene;
}

struct Options {
    double particles = 1e6;
    bool look = false;  ///< the figures of a whole report too
};

Options options_of(int count, char** words) {
    Options options;
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        char* end = nullptr;
        const double particles = std::strtod(word.c_str(), &end);
        if (word == "--inspect") {
            options.look = true;
        } else if (*end == '\0' && particles >= 100 && particles <= 1e9) {
            options.particles = particles;
        } else {
            throw InputError({}, "'" + word + "' is neither a number of particles, from 100 to 1e9, nor --inspect",
                             "usage: dmp_bench_mesh [FLUID PARTICLES] [--inspect]");
        }
    }
    return options;
}

int measure(const Options& options) {
    const double spacing = std::cbrt(4.0 / 3 * std::numbers::pi / options.particles);
    const Scene scene = scene_of(spacing);
    Geometry geometry;
    geometry.dimension = 3;
    geometry.solids.push_back({"ball", icosphere(6, 1)});
    geometry.surfaces.push_back({"shell", geometry.solids.front().surface});
    geometry.box = {Vec::Constant(-1), Vec::Constant(1)};
    MeshResult result = mesh(geometry, scene);
    if (options.look) inspect(result, geometry, scene);
    fmt::print("{}", result.report.text());
    // On a busy machine the processor's time says more than the clock's.
    const MeshReport& report = result.report;
    const auto rate = [](std::size_t of, double seconds) { return static_cast<double>(of) / seconds; };
    double walls = 0;
    for (const char* stage : {"nearest triangles", "walls"}) walls += report.cost.of(stage).processor_seconds;
    double filling = 0;
    for (const char* stage : {"lattice", "fluids"}) filling += report.cost.of(stage).processor_seconds;
    for (const auto& stage : report.cost.stages)
        fmt::print("{:<18} {:>8.3f} s of processor\n", stage.name, stage.processor_seconds);
    fmt::print("candidates {:.3g}/s, wall particles {:.3g}/s, all particles {:.3g}/s\n",
               rate(report.cost.candidates, report.cost.of("lattice").processor_seconds),
               rate(report.parts[1].particles, walls), rate(result.particles.size(), filling + walls));
    return 0;
}

}  // namespace

int main(int count, char** words) {
    return cli::exit_code_of([&] { return measure(options_of(count, words)); });
}
