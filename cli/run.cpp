// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "cli/chosen.hpp"
#include "cli/commands.hpp"
#include "cli/dry_run.hpp"
#include "cli/exit_codes.hpp"
#include "cli/failure.hpp"
#include "cli/output_folder.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/results_folder.hpp"
#include "cli/run_bounds.hpp"
#include "cli/stop_signals.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "cli/workstation.hpp"
#include "postproc/tables.hpp"
#include "scene/read_scene.hpp"
#include "solver/output/hdf5_sink.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Wall time of the trial that a dry run's estimate rests on [s].
constexpr double trial_seconds = 1.0;

/// A time from the command line [s], or what holds when it was not given.
double time_of(const std::string& option, const std::string& text, double otherwise, bool may_be_zero = false) {
    if (text.empty()) return otherwise;
    const SourceLocation location{option, 0, 0};
    const double time = read_quantity(text, "s", location);
    if (!(time > 0 || (may_be_zero && time == 0))) {
        throw InputError(location, "'" + text + "' is no time for this",
                         "Give a time after 0, e.g. " + option + " \"0.2 s\".");
    }
    return time;
}

constexpr double seconds_between_checkpoints = 600;

FrameFormat frame_format(const RunCommand& command) {
    return command.frames.value_or(workstation_libraries().empty() ? FrameFormat::hdf5 : FrameFormat::vtk);
}

/// This rank's; none where the first one writes for all.
std::unique_ptr<FrameSeries> frame_series(FrameFormat format, const fs::path& folder, const Scene& scene,
                                          const Ranks& ranks) {
    if (format == FrameFormat::hdf5) return std::make_unique<Hdf5Sink>(folder, label_of(scene), ranks);
    return ranks.is_first() ? paraview_frames(folder, label_of(scene)) : nullptr;
}

PictureOptions picture_options(const Scene& scene) {
    PictureOptions options{.field = to_string(*scene.output.picture_field)};
    for (const BoxSide side : *scene.flow.symmetry) options.mirrored.at(axis_of(side)).at(is_high(side) ? 1 : 0) = true;
    return options;
}

/// Pictures are drawn of ParaView's files.
Pictures draw(FrameFormat format, const Scene& scene, const fs::path& folder, ProgressLine& line) {
    if (!*scene.output.pictures || format != FrameFormat::vtk) return {};
    line.show("geometry pictures");
    Pictures result = draw_pictures(folder, picture_options(scene));
    line.clear();
    return result;
}

/// Runs to the end; of a run that diverges it also says where its frames are.
RunSummary simulate(Simulation& simulation, const RunOptions& options, const fs::path& folder) {
    try {
        return simulation.run(options);
    } catch (const DivergenceError& error) {
        throw DivergenceError(error.problem(),
                              error.what_to_do() + "\nThe frames up to there are in " + folder.string());
    }
}

/// Everything the run leaves besides the frames, whose files are given; returns the names of all.
std::vector<std::string> write_results(const fs::path& folder, const Scene& scene, const RunSummary& summary,
                                       std::vector<std::string> files, FrameFormat format, ProgressLine& line) {
    files.emplace_back(resolved_scene_name);
    if (!summary.measures.names.empty()) files.emplace_back(measures_file_name);
    files.emplace_back(summary_file_name);
    // Before the pictures, so that whoever stops those has the numbers.
    write_summary(folder, summary, {label_of(scene), files});
    if (summary.interrupted) return files;

    const Pictures pictures = draw(format, scene, folder, line);
    files.insert(files.end(), pictures.files.begin(), pictures.files.end());
    write_summary(folder, summary, {label_of(scene), files});
    if (!pictures.warning.empty()) print(Style(Stream::output).warning("warning: ") + pictures.warning + "\n");
    return files;
}

/// Where the run goes on, if it is to.
std::optional<FoundCheckpoint> found_checkpoint(const RunCommand& command, const fs::path& folder,
                                                const std::string& scene) {
    if (!command.resume) return std::nullopt;
    return checkpoint_to_resume(folder, scene);
}

/// What the first rank knows of the folder it writes into.
struct Destination {
    Destination(const RunCommand& command, const std::string& scene, fs::path folder, double until, int ranks)
        : results(std::move(folder), {scene, until, command.resume, command.overwrite}, command.typed.on_ranks(ranks)),
          checkpoint(found_checkpoint(command, results.path(), scene)) {}

    ResultsFolder results;
    std::optional<FoundCheckpoint> checkpoint;  ///< none: the run starts from the beginning
};

/// Says where the run goes on, or removes what an earlier one has left: nothing refuses the run any more.
void open_folder(const Destination& destination) {
    const fs::path& folder = destination.results.path();
    if (!destination.results.note().empty()) print(destination.results.note() + "\n");
    if (const auto& found = destination.checkpoint) {
        for (const std::string& message : found->messages)
            print(Style(Stream::output).warning("warning: ") + message + "\n");
        print("Going on in " + folder.string() + " from step " + std::to_string(found->step) + "\n\n");
        return;
    }
    CheckpointFolder(folder).make();  // may refuse
    if (const std::string removed = remove_results(folder); !removed.empty()) print(removed + "\n");
    print("Writing to " + folder.string() + "\n\n");
}

/// The first rank, which speaks, writes and draws.
int run_as_first(const RunCommand& command, Prepared prepared, const Resources& resources, RunOptions options,
                 Destination* destination) {
    const Scene& scene = prepared.scene;
    const std::string head = heading(prepared);
    const ParticleSet particles = command.dry_run ? prepared.particles : ParticleSet{};
    Simulation simulation(scene, prepared.particles, resources);
    prepared.particles = {};
    Plan plan = simulation.plan();
    check_steps(scene, plan, options.until);
    if (auto warning = frames_rule_steps(scene, plan)) plan.warnings.push_back(std::move(*warning));
    print(head + "\n" + chosen_text(scene, plan, prepared.origin) + "\n");
    flush_output();
    for (const std::string& warning : prepared.origin.warnings)
        print_error(Style(Stream::error).warning("warning:") + " " + warning + "\n");
    for (const Warning& warning : plan.warnings)
        print_error(Style(Stream::error).warning("warning:") + " " + warning.text() + "\n");
    if (command.dry_run) {
        flush_output();
        print(dry_run_text(scene, plan, try_out(scene, particles, resources, options.until, trial_seconds),
                           options.until));
        return exit_done;
    }

    const fs::path& folder = destination->results.path();
    options.checkpoints.scene = resolved_scene(scene);
    options.checkpoints.folder = folder;
    const FrameFormat format = frame_format(command);
    const auto sink = frame_series(format, folder, scene, resources.ranks);
    open_folder(*destination);
    flush_output();
    const auto& found = destination->checkpoint;
    std::string checkpoint = found ? found->file.string() : "";
    resources.ranks.broadcast(checkpoint);
    if (found) sink->go_on(simulation.resume(checkpoint));

    write_file(folder / resolved_scene_name, options.checkpoints.scene);
    ProgressLine line;
    const StopSignals signals;
    options.sink = sink.get();
    options.progress = [&](const RunProgress& progress) {
        destination->results.check();
        line.show(progress);
    };
    options.warn = [&](double time, const Warning& warning) {
        line.clear();
        print_error(Style(Stream::error).warning("warning:") + " at " + quantity_text(time, "s") + ": " +
                    warning.text() + "\n");
    };
    MeasuresFile measures(folder);
    options.measured = [&](const MeasureSeries& series) {
        if (!series.names.empty()) measures.write(series);
    };
    options.stop = &signals.flag();
    const RunSummary summary = simulate(simulation, options, folder);
    line.clear();

    print(summary_text(scene, summary));
    flush_output();
    const auto files = write_results(folder, scene, summary, sink->files(), format, line);
    print("\n" + results_text(folder, files));
    flush_output();
    for (const Warning& warning : summary.warnings)
        print_error(Style(Stream::error).warning("warning:") + " " + warning.text() + "\n");
    if (summary.interrupted)
        print("Stopped before its end" + std::string(summary.out_of_time ? ", out of its wall time" : "") +
              ". Go on with the same command and --resume.\n  " +
              command.typed.on_ranks(resources.ranks.size()).with("--resume") + "\n");
    if (summary.out_of_time) return exit_out_of_resource;
    return summary.interrupted ? signals.exit_code() : exit_done;
}

/// Any other rank.
int run_as_one_of_many(const RunCommand& command, Prepared prepared, const Resources& resources, RunOptions options) {
    const ParticleSet particles = command.dry_run ? prepared.particles : ParticleSet{};
    Simulation simulation(prepared.scene, prepared.particles, resources);
    prepared.particles = {};
    if (command.dry_run) {
        static_cast<void>(try_out(prepared.scene, particles, resources, options.until, trial_seconds));
        return exit_done;
    }
    options.checkpoints.folder = output_folder(command.out, scene_name(prepared.scene));
    std::string checkpoint;
    resources.ranks.broadcast(checkpoint);
    const auto sink = frame_series(frame_format(command), options.checkpoints.folder, prepared.scene, resources.ranks);
    options.sink = sink.get();
    if (!checkpoint.empty()) {
        const long frames = simulation.resume(checkpoint);
        if (sink) sink->go_on(frames);
    }
    const StopSignals signals;
    options.stop = &signals.flag();
    simulation.run(options);
    return exit_done;
}

}  // namespace

int execute(const RunCommand& command) {
    const MpiSession session;
    return on_all_ranks(session, [&] {
        Resources resources;
        resources.ranks = session.ranks();
        resources.vector_unit = chosen_vector_unit(command.vector_unit);
        Scene scene = read_scene(command.scene.path, command.scene.overrides);
        resources.threads = threads_for(scene, command.threads);
        // Ranks that share a machine share its processors.
        if (resources.threads == 0 && resources.ranks.size() > 1) resources.threads = 1;

        RunOptions options;
        options.until = time_of("--until", command.until, scene.run.duration);
        options.wall_limit = time_of("--wall-limit", command.wall_limit, 0);
        options.checkpoints.every =
            time_of("--checkpoint-every", command.checkpoint_every, seconds_between_checkpoints, true);

        check_frames(scene, options.until);
        // Before particles are made, which may take long.
        std::optional<Destination> destination;
        if (resources.ranks.is_first() && !command.dry_run)
            destination.emplace(command, resolved_scene(scene), output_folder(command.out, scene_name(scene)),
                                options.until, resources.ranks.size());
        Prepared prepared = prepare(std::move(scene), command.scene, resources.ranks);
        return resources.ranks.is_first() ? run_as_first(command, std::move(prepared), resources, options,
                                                         destination ? &*destination : nullptr)
                                          : run_as_one_of_many(command, std::move(prepared), resources, options);
    });
}

}  // namespace dmp::cli
