// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/checkpoints.hpp"

#include <memory>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "scene/scene_difference.hpp"
#include "solver/state/checkpoint_file.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

Checkpoints::Checkpoints(const Ranks& ranks, CheckpointOptions options)
    : ranks_(ranks), options_(std::move(options)), folder_(options_.folder) {
    if (wanted() && ranks_.is_first()) folder_.make();
}

bool Checkpoints::due() const {
    return wanted() && options_.every > 0 &&
           std::chrono::duration<double>(Clock::now() - last_).count() >= options_.every;
}

void Checkpoints::save(long step, const ArchiveAll& archive_all) {
    std::string problem, what_to_do;
    std::unique_ptr<CheckpointWriter> file;
    // The other ranks must not wait for rank 0 after an error: it continues, and broadcasts the error at the end.
    const auto on_first = [&](const auto& work) {
        if (!ranks_.is_first() || !problem.empty()) return;
        try {
            work();
        } catch (const ResourceError& error) {
            problem = error.problem();
            what_to_do = error.what_to_do();
        }
    };
    on_first([&] {
        file = std::make_unique<CheckpointWriter>(folder_.path_for(step));
        file->contents().write_text("scene", options_.scene);
    });
    Archive archive(ranks_, file ? &file->contents() : nullptr);
    try {
        archive_all(archive);
    } catch (const ResourceError& error) {
        if (ranks_.size() > 1) throw;
        problem = error.problem();
        what_to_do = error.what_to_do();
    }
    on_first([&] {
        file->finish();
        folder_.keep_last_two(step);
    });
    ranks_.broadcast(problem);
    ranks_.broadcast(what_to_do);
    if (!problem.empty()) throw ResourceError(problem, what_to_do);
    last_ = Clock::now();
}

FoundCheckpoint checkpoint_to_resume(const std::filesystem::path& folder, const std::string& scene, double until) {
    auto found = CheckpointFolder(folder).newest_good();
    if (!found)
        throw InputError("there is no checkpoint in " + folder.string() + " to resume from",
                         "Leave out --resume to start the run, or give the folder of the run with --out.");
    const CheckpointReader file(found->file);
    found->time = file.contents().number<double>("time");
    if (const auto changed = differences_in_state(file.contents().text("scene"), scene); !changed.empty())
        throw InputError({found->file.string()},
                         "the scene is not the one this run was started with:" + differences_text(changed),
                         "Resume with the original scene, or start a new run in another folder with --out.");
    if (!(until > found->time))
        throw InputError({found->file.string()},
                         "the run has got to t = " + number_text(found->time, 6) + " s, and is asked to end at " +
                             number_text(until, 6) + " s",
                         "Resume it with a later --until or run.duration.");
    return *found;
}

}  // namespace dmp::solver
