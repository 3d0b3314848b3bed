// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/given_reference.hpp"

#include <string>
#include <vector>

#include "base/errors.hpp"
#include "cli/output_folder.hpp"
#include "postproc/tables.hpp"
#include "scene/read_scene.hpp"
#include "scene/scene_difference.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// What a finer run may have otherwise.
bool is_of_resolution(const std::string& key) {
    return key == "quality" || key.starts_with("particles.") || key.starts_with("numerics.") ||
           (key.starts_with("part.") && key.ends_with(".layers"));
}

void need_same_scene(const fs::path& folder, const std::string& as_run, const Scene& scene) {
    std::vector<scene::ValueDifference> others = scene::differences_in_state(as_run, resolved_scene(scene));
    std::erase_if(others, [](const scene::ValueDifference& each) { return is_of_resolution(each.key); });
    if (!others.empty())
        throw InputError({folder.string(), 0, 0},
                         "this reference is a run of another scene:" + scene::differences_text(others),
                         "Run the scene of the trade with a smaller particles.spacing, and give that run's folder.");
}

}  // namespace

GivenReference given_reference(const fs::path& folder, const Scene& scene) {
    const FolderContents contents = contents_of(folder);
    if (contents.kind != FolderContents::Kind::finished)
        throw InputError({"--reference", 0, 0}, "'" + folder.string() + "' is no folder of a run that has ended",
                         "Give that of a 'dmp run' of this scene with a smaller spacing.");
    need_same_scene(folder, contents.scene, scene);
    GivenReference given;
    given.folder = folder;
    given.measures = postproc::read_measures_csv(folder);
    const Scene as_run = read_scene((folder / resolved_scene_name).string());
    given.setting.role = study::TradeRole::reference;
    given.setting.level = study::level_of(as_run, scene);
    if (as_run.particles.spacing.given()) {
        given.setting.spacing = *as_run.particles.spacing;
        given.setting.spacing_text = study::spacing_text(given.setting.spacing);
    }
    return given;
}

}  // namespace dmp::cli
