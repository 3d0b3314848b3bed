// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/run_words.hpp"

#include "base/errors.hpp"
#include "cli/output_folder.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_table.hpp"
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

study::LeftOut left_out_of(const study::Study& study, std::size_t runs) {
    using enum study::RunOutput;
    if (study.left_out.given()) return study.left_out;
    return runs > study::most_runs_with_pages ? study::LeftOut{pictures, page} : study::LeftOut{};
}

std::vector<std::string> run_line(const study::Study& study, const study::Point& point, const fs::path& folder,
                                  const std::string& program, int threads, const study::LeftOut& left_out) {
    std::vector<std::string> words{program,
                                   "run",
                                   study.scene.file,
                                   "--out",
                                   run_folder(folder, point.name).string(),
                                   "--threads",
                                   std::to_string(threads)};
    for (const std::string& each : study::overrides(study, point)) words.insert(words.end(), {"--set", each});
    for (const study::RunOutput each : left_out) words.insert(words.end(), {"--leave-out", to_string(each)});
    return words;
}

RunWords words_for_run(const study::Study& study, const study::Point& point, const fs::path& folder,
                       const std::string& program, int threads, const study::LeftOut& left_out) {
    RunWords start{run_line(study, point, folder, program, threads, left_out), ""};
    const fs::path run = run_folder(folder, point.name);
    const FolderContents contents = contents_of(run);
    bool resumed = contents.kind == FolderContents::Kind::unfinished && contents.has_checkpoint;
    if (resumed) {
        const std::string refused = refused_checkpoint(study.scene.file, study::overrides(study, point), run);
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
