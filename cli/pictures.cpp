// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/pictures.hpp"

#include <filesystem>

#include "base/errors.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/output_folder.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/workstation.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

PictureOptions picture_options(const Scene& scene) {
    PictureOptions options{.field = to_string(*scene.output.picture_field)};
    for (const BoxSide side : *scene.flow.symmetry) options.mirrored.at(axis_of(side)).at(is_high(side) ? 1 : 0) = true;
    return options;
}

int execute(const PicturesCommand& command) {
    refuse_several_ranks();
    const std::filesystem::path folder = command.folder;
    if (workstation_libraries().empty())
        throw InputError("this dmp was built for clusters, without VTK, and cannot draw pictures",
                         "Copy the run's folder to a workstation and draw them there.");
    const std::filesystem::path scene_file = folder / resolved_scene_name;
    if (!std::filesystem::exists(scene_file))
        throw InputError({folder.string()}, "there is no run here: it has no " + std::string(resolved_scene_name),
                         "Give the folder of a run, the one with frames/ in it.");
    for (const std::string& set : command.overrides)
        if (!set.starts_with("output.picture_field=") && !set.starts_with("flow.symmetry="))
            throw InputError({"--set " + set}, "pictures of a run that is done do not depend on it",
                             "Set output.picture_field or flow.symmetry only.");
    const Scene scene = read_scene(scene_file.string(), command.overrides);
    PictureOptions options = picture_options(scene);
    options.film = command.film;
    ProgressLine line;
    line.show("pictures");
    const Pictures pictures = draw_pictures(folder, options);
    line.clear();
    if (!pictures.warning.empty()) print_error(Style(Stream::error).warning("warning: ") + pictures.warning + "\n");
    for (const std::string& file : pictures.files) print((folder / file).string() + "\n");
    return exit_done;
}

}  // namespace dmp::cli
