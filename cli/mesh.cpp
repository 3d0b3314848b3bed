// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/mesh_drawing.hpp"
#include "cli/output_folder.hpp"
#include "cli/particle_frame.hpp"
#include "cli/particle_input.hpp"
#include "cli/prepare.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "particles/particle_file.hpp"
#include "postproc/vtk_sink.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

int execute(const MeshCommand& command) {
    refuse_several_ranks();
    Scene scene = read_scene(command.scene.path, command.scene.overrides);
    MeshResult made = mesh_drawing(scene);
    Origin origin = origin_of(scene, made.report);
    const Prepared prepared{std::move(scene), std::move(made.particles), std::move(origin)};
    const auto folder = output_folder(command.out, scene_name(prepared.scene) + "_mesh");
    const std::string removed = prepare_folder(folder);
    print(heading(prepared) + "\n" + made.report.text() + "\n");
    if (!removed.empty()) print(removed + "\n");

    write_file(folder / resolved_scene_name, resolved_scene(prepared.scene));
    VtkSink sink(folder, label_of(prepared.scene));
    sink.write(particle_frame(prepared.particles));
    std::vector<std::string> files = sink.files();
    files.emplace_back(resolved_scene_name);
    print(results_text(folder, files));
    if (command.particles.empty()) return exit_done;
    const std::filesystem::path file = command.particles;
    if (file.has_parent_path()) make_folder(file.parent_path());
    write_particles(file, prepared.particles, values_behind_particles(prepared.scene));
    print("Particles for 'dmp run --particles': " + file.string() + "\n");
    return exit_done;
}

}  // namespace dmp::cli
