// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_words.hpp"

#include "base/errors.hpp"
#include "cli/output_folder.hpp"
#include "cli/sweep_folder.hpp"
#include "cli/sweep_table.hpp"
#include "scene/read_scene.hpp"
#include "solver/state/checkpoints.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Why a run that was begun cannot go on from any of its checkpoints; "": it can. What else stands against it, such as
/// another geometry, is the run's error.
std::string refused_checkpoint(const std::string& scene_file, const std::vector<std::string>& overrides,
                               const fs::path& run) {
    const Scene scene = read_scene(scene_file, overrides);
    try {
        static_cast<void>(checkpoint_to_resume(run, resolved_scene(scene), *scene.run.duration));
    } catch (const InputError& error) {
        return one_line(error);
    }
    return "";
}

}  // namespace

RunWords words_for_run(const study::Study& study, const study::Point& point, const fs::path& folder,
                       const std::string& program, int threads) {
    const fs::path run = run_folder(folder, point.name);
    RunWords start{{program, "run", study.scene.file, "--out", run.string(), "--threads", std::to_string(threads)}, ""};
    const std::vector<std::string> overrides = study::overrides(study.keys(), point);
    for (const std::string& each : overrides) start.words.insert(start.words.end(), {"--set", each});
    const FolderContents contents = contents_of(run);
    bool resumed = contents.kind == FolderContents::Kind::unfinished && contents.has_checkpoint;
    if (resumed) {
        const std::string refused = refused_checkpoint(study.scene.file, overrides, run);
        if (!refused.empty())
            start.note = "run " + point.name + " cannot go on from its checkpoint, and starts anew: " + refused;
        resumed = refused.empty();
    }
    if (resumed)
        start.words.emplace_back("--resume");
    else if (contents.kind != FolderContents::Kind::nothing)
        start.words.emplace_back("--overwrite");
    return start;
}

}  // namespace dmp::cli
