// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/checkpoints.hpp"

#include <algorithm>
#include <memory>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "scene/scene_difference.hpp"
#include "solver/state/checkpoint_file.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// Tells times apart that a run steps to.
constexpr double same_time = 1e-9;

void write_label(Hdf5Writer& file, const CheckpointLabel& label) {
    file.write_text("scene", label.scene);
    if (!label.dmp_version.empty()) file.write_text("dmp_version", label.dmp_version);
    if (!label.particles.empty()) file.write_text("particles", label.particles);
    if (!label.started_from) return;
    file.write_text("started_from/checkpoint", label.started_from->checkpoint);
    file.write_number<std::int64_t>("started_from/step", label.started_from->step);
    file.write_number<double>("started_from/time", label.started_from->time);
}

/// Of a checkpoint of which only the file and the step are known.
void read_label(FoundCheckpoint& found) {
    const CheckpointReader reader(found.file);
    const Hdf5Reader& file = reader.contents();
    const auto text = [&](const std::string& name) { return file.has(name) ? file.text(name) : ""; };
    found.time = file.number<double>("time");
    found.label = {file.text("scene"), text("dmp_version"), text("particles"), {}};
    if (file.has("started_from/checkpoint"))
        found.label.started_from =
            StartedFrom{file.text("started_from/checkpoint"), file.number<std::int64_t>("started_from/step"),
                        file.number<double>("started_from/time")};
}

std::string time_text(double time) { return number_text(time, 9) + " s"; }

}  // namespace

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
        write_label(file->contents(), options_.label);
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
    read_label(*found);
    if (const auto changed = differences_in_state(found->label.scene, scene); !changed.empty())
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

FoundCheckpoint checkpoint_to_start_from(const std::filesystem::path& folder, std::optional<double> at, double until) {
    std::vector<FoundCheckpoint> all = CheckpointFolder(folder).all_good();
    if (all.empty())
        throw InputError({folder.string()}, "there is no checkpoint here to start from",
                         "Give the folder of a run, the one with checkpoints/ in it.");
    std::string there;
    for (FoundCheckpoint& found : all) {
        read_label(found);
        there += "\n  " + time_text(found.time) + ", step " + std::to_string(found.step);
    }
    const auto chosen = std::ranges::find_if(
        all, [&](const FoundCheckpoint& found) { return !at || found.time <= *at * (1 + same_time); });
    if (chosen == all.end())
        throw InputError({folder.string()},
                         "it holds no checkpoint of t = " + time_text(*at) + " or before; those there are:" + there,
                         "Give one of these times, or none for the last one. A run keeps its last two checkpoints; "
                         "--checkpoint-every says how often it writes one.");
    if (!(until > chosen->time))
        throw InputError(
            {chosen->file.string()},
            "its state is of t = " + time_text(chosen->time) + ", and the run is asked to end at " + time_text(until),
            "Time goes on from there: give a later --until or run.duration.");
    return *chosen;
}

}  // namespace dmp::solver
