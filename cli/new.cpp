// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/first_guess.hpp"
#include "cli/first_scene.hpp"
#include "cli/geometry_report.hpp"
#include "cli/prepare.hpp"
#include "cli/terminal.hpp"
#include "cli/uses.hpp"
#include "geometry/geometry_file.hpp"
#include "geometry/repair_solids.hpp"
#include "geometry/triangle_geometry.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

void refuse_what_is_there(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(folder, error) || (fs::is_directory(folder, error) && fs::is_empty(folder, error))) return;
    throw InputError({folder.string(), 0, 0}, "there is something of this name already",
                     "Give the new scene another name; nothing is overwritten.");
}

/// What a run would close, with the repairs of a scene that asks for none of its own. Where there is a closed body,
/// open surfaces are walls and sheets.
void close_as_a_run_does(Geometry& geometry) {
    if (!geometry.solids.empty()) return;
    RepairLimits limits;
    limits.spacing = geometry.box.extent().minCoeff() / particles_across;
    if (!(limits.spacing > 0)) return;
    std::vector<std::string> open;
    for (const SurfaceSet& set : geometry.surfaces)
        if (!set.why_open.empty()) open.push_back(set.name);
    for (const std::string& name : open) {
        try {
            (void)repair_solids(geometry, {name}, limits);
        } catch (const UnusableSurface&) {  // nor would a run
        }
    }
}

}  // namespace

int execute(const NewCommand& command) {
    refuse_several_ranks();
    const fs::path folder = command.folder;
    refuse_what_is_there(folder);
    check_output_folder(folder);
    const GeometryOptions options = geometry_options(command.cad_geometry, command.unit);
    Geometry geometry = read_for_inspection(options, command.reading);
    // A gmsh geometry states none either: a run takes metres for it, which would be a guess here.
    const bool unit_known = states_its_unit(options.file) || options.unit.has_value();
    if (!unit_known) throw missing_unit(options, geometry.box);
    close_as_a_run_does(geometry);
    const FirstScene first = first_scene(geometry, options.unit.has_value());

    make_folder(folder);
    const fs::path scene = folder / "scene.toml";
    std::error_code error;
    fs::copy_file(command.cad_geometry, folder / fs::path(command.cad_geometry).filename(), error);
    if (error) throw_write_error(folder / fs::path(command.cad_geometry).filename(), error.message());
    write_file(scene, first.text);
    (void)read_scene(scene.string(), {});
    std::string text = Style(Stream::output).strong(scene.string()) + " assumes:\n";
    for (const std::string& assumption : first.assumptions) text += "  - " + assumption + "\n";
    print(text + fmt::format("\nNext: {0} mesh {1}\n      {0} run {1} --dry-run\n      {0} run {1}\n",
                             command.typed.program(), shell_word(folder.string())));
    return exit_done;
}

}  // namespace dmp::cli
