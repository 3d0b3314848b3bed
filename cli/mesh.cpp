// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/output_folder.hpp"
#include "cli/particle_frame.hpp"
#include "cli/prepare.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "postproc/vtk_sink.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

int execute(const MeshCommand& command) {
    refuse_several_ranks();
    const Prepared prepared = prepare(command.scene);
    const auto folder = output_folder(command.out, scene_name(prepared.scene) + "_mesh");
    const std::string removed = prepare_folder(folder);
    print(heading(prepared) + "\n" + prepared.mesh.report.text() + "\n");
    if (!removed.empty()) print(removed + "\n");

    write_file(folder / resolved_scene_name, resolved_scene(prepared.scene));
    VtkSink sink(folder, label_of(prepared.scene));
    sink.write(particle_frame(prepared.mesh.particles));
    std::vector<std::string> files = sink.files();
    files.emplace_back(resolved_scene_name);
    print(results_text(folder, files));
    return exit_done;
}

}  // namespace dmp::cli
