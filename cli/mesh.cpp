// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/mesh_cache.hpp"
#include "cli/mesh_geometry.hpp"
#include "cli/mesh_view.hpp"
#include "cli/output_folder.hpp"
#include "cli/particle_frame.hpp"
#include "cli/particle_input.hpp"
#include "cli/prepare.hpp"
#include "cli/rest_test.hpp"
#include "cli/results_folder.hpp"
#include "cli/scene_as_run.hpp"
#include "cli/scene_name.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "cli/uses.hpp"
#include "mesher/mesh_spheres.hpp"
#include "particles/particle_file.hpp"
#include "postproc/vtk_sink.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

int execute(const MeshCommand& command) {
    refuse_several_ranks();
    Scene scene = read_scene(command.scene.path, command.scene.overrides);
    if (command.rest_test && is_of_spheres(scene))
        throw InputError("--settle is for fluids and their walls, and this is a scene of spheres",
                         "leave --settle out");
    const ResultsFolder results(output_folder(command.out, scene_name(scene) + "_mesh"), command.typed);
    const std::filesystem::path& folder = results.path();
    if (!command.particles.empty()) check_output_file(command.particles);
    MeshDetail detail;
    MeshReport report;
    const auto make = [&]() -> ParticlesWithOrigin {
        MeshResult made = mesh_geometry(scene, command.scene.reading, detail);
        report = std::move(made.report);
        return {std::move(made.particles), origin_of(scene, report)};
    };
    ParticlesWithOrigin fresh = command.scene.reading.trusted ? make() : MeshCache().make(scene, make);
    const Prepared prepared{std::move(scene), std::move(fresh.particles), std::move(fresh.origin)};
    if (command.rest_test) report.at_rest = rest_test(prepared.scene, prepared.particles);
    print(heading(prepared) + "\n" + report.text() + "\n");
    if (const std::string removed = remove_results(folder); !removed.empty()) print(removed + "\n");

    write_file(folder / mesh_report_name, report.json());
    write_scene(folder, prepared.scene);
    VtkSink sink(folder, label_of(prepared.scene));
    sink.write(particle_frame(prepared.particles));
    std::vector<std::string> files = sink.files();
    files.emplace_back(resolved_scene_name);
    files.emplace_back(mesh_report_name);
    if (*prepared.scene.output.pictures && !is_of_spheres(prepared.scene)) {
        const std::string& title = *prepared.scene.title;
        const Pictures pictures = write_mesh_pictures(
            folder, mesh_view(prepared.particles, detail, title.empty() ? scene_name(prepared.scene) : title));
        files.insert(files.end(), pictures.files.begin(), pictures.files.end());
        if (!pictures.warning.empty()) print(Style(Stream::output).warning("warning: ") + pictures.warning + "\n");
    }
    print(results_text(folder, files));
    const ExitCode code = report.at_rest && !report.at_rest->holds() ? exit_diverged : exit_done;
    if (command.particles.empty()) return code;
    const std::filesystem::path file = command.particles;
    write_particles(file, prepared.particles, values_behind_particles(prepared.scene));
    print("Particles for 'dmp run --particles': " + file.string() + "\n");
    return code;
}

}  // namespace dmp::cli
