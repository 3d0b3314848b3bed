// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/first_scene.hpp"
#include "cli/geometry_report.hpp"
#include "cli/prepare.hpp"
#include "cli/terminal.hpp"
#include "cli/uses.hpp"
#include "geometry/geometry_file.hpp"
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

}  // namespace

int execute(const NewCommand& command) {
    refuse_several_ranks();
    const fs::path folder = command.folder;
    refuse_what_is_there(folder);
    check_output_folder(folder);
    const GeometryOptions options = geometry_options(command.cad_geometry, command.unit);
    const Geometry geometry = read_for_inspection(options, command.reading);
    if (needs_a_unit(options.file) && !options.unit) throw missing_unit(options, geometry.box);
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
