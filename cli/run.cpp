// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/numbered_files.hpp"
#include "base/safe_file.hpp"
#include "base/shell_word.hpp"
#include "base/wall_clock.hpp"
#include "cli/chosen.hpp"
#include "cli/commands.hpp"
#include "cli/dry_run.hpp"
#include "cli/exit_codes.hpp"
#include "cli/failure.hpp"
#include "cli/output_folder.hpp"
#include "cli/pictures.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/references.hpp"
#include "cli/results_folder.hpp"
#include "cli/run_bounds.hpp"
#include "cli/run_log.hpp"
#include "cli/scene_as_run.hpp"
#include "cli/scene_name.hpp"
#include "cli/start_from.hpp"
#include "cli/stop_signals.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/trade/known_trade.hpp"
#include "cli/uses.hpp"
#include "cli/version.hpp"
#include "cli/workstation.hpp"
#include "particles/fingerprint.hpp"
#include "postproc/tables.hpp"
#include "report/write_report.hpp"
#include "scene/read_scene.hpp"
#include "solver/output/hdf5_sink.hpp"
#include "solver/results/expected_steps.hpp"
#include "solver/simulation.hpp"
#include "solver/state/checkpoint_folder.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Of the trial that a dry run's estimate rests on, where nobody asks for another [s].
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

/// [s]
double trial_of(const RunCommand& command) { return time_of("--trial", command.trial, trial_seconds, true); }

FrameFormat frame_format(const RunCommand& command) {
    return command.frames.value_or(workstation_libraries().empty() ? FrameFormat::hdf5 : FrameFormat::vtk);
}

/// This rank's; none where the first one writes for all, or there are to be none.
std::unique_ptr<FrameSeries> frame_series(const RunCommand& command, const fs::path& folder, const Scene& scene,
                                          const Ranks& ranks) {
    if (command.left_out.contains(study::RunOutput::frames)) return nullptr;
    const FrameFormat format = frame_format(command);
    if (format == FrameFormat::hdf5) return std::make_unique<Hdf5Sink>(folder, label_of(scene), ranks);
    return ranks.is_first() ? paraview_frames(folder, label_of(scene)) : nullptr;
}

/// Pictures are drawn of ParaView's files.
Pictures draw(const RunCommand& command, const Scene& scene, const fs::path& folder, ProgressLine& line) {
    const bool left_out =
        command.left_out.contains(study::RunOutput::pictures) || command.left_out.contains(study::RunOutput::frames);
    if (left_out || !*scene.output.pictures || frame_format(command) != FrameFormat::vtk) return {};
    line.show("geometry pictures");
    Pictures result = draw_pictures(folder, picture_options(scene));
    line.clear();
    return result;
}

/// Whether it was written. Of a run that is done, a page that cannot be written is no error.
bool write_page(const fs::path& folder, RunLog& log) {
    try {
        write_run_report(folder, stored_paraview_frames);
        return true;
    } catch (const Error& error) {
        log.warn(fmt::format(": the run's page {} was not written: {}", report_file_name, error.problem()));
        return false;
    }
}

/// Runs to the end; what ends it before that is in the log. A run that diverges leaves a page, too, and says where its
/// frames are.
RunSummary simulate(Simulation& simulation, const RunOptions& options, const fs::path& folder, RunLog& log) {
    const auto note = [&](const Error& error) {
        try {
            log.add(error_text(error.where().text(), error.problem(), error.what_to_do(), false));
        } catch (const Error&) {
            // The first error counts, also where the log cannot be written.
        }
    };
    try {
        return simulation.run(options);
    } catch (const DivergenceError& error) {
        const DivergenceError with_place(
            error.problem(),
            error.what_to_do() +
                (options.sink == nullptr ? "\nWhat it has measured is in " : "\nThe frames up to there are in ") +
                folder.string());
        note(with_place);
        if (write_page(folder, log))
            print(shell_word((folder / report_file_name).string()) + "   the page of the run, for a browser\n");
        throw with_place;
    } catch (const Error& error) {
        note(error);  // and no page: the disk may be full, or the folder another process's
        throw;
    }
}

/// Everything the run leaves besides the frames, whose files are given in `extra`; returns the names of all.
std::vector<std::string> write_results(const fs::path& folder, const Scene& scene, const RunSummary& summary,
                                       SummaryExtra extra, const RunCommand& command, ProgressLine& line, RunLog& log) {
    std::vector<std::string>& files = extra.files;
    files.emplace_back(resolved_scene_name);
    if (!summary.measures.names.empty()) files.emplace_back(measures_file_name);
    if (fs::exists(folder / references_file_name)) files.emplace_back(references_file_name);
    files.emplace_back(summary_file_name);
    files.emplace_back(run_log_name);
    // Before the pictures, so that whoever stops those has the numbers.
    write_summary(folder, summary, extra);

    const Pictures pictures = draw(command, scene, folder, line);
    files.insert(files.end(), pictures.files.begin(), pictures.files.end());
    write_summary(folder, summary, extra);
    if (!pictures.warning.empty()) log.warn(": " + pictures.warning);
    if (command.left_out.contains(study::RunOutput::page)) return files;
    if (write_page(folder, log)) {
        files.emplace_back(report_file_name);
        write_summary(folder, summary, extra);
    }
    return files;
}

/// What the first rank knows of the folder it writes into.
struct Destination {
    Destination(const RunCommand& command, const Scene& scene, fs::path folder, double end, int ranks)
        : results(std::move(folder), {resolved_scene(scene), end, command.resume, command.overwrite},
                  command.typed.on_ranks(ranks)),
          until(end) {
        if (command.resume) to_resume = checkpoint_to_resume(results.path(), resolved_scene(scene), until);
        if (!command.from.empty())
            to_start = starting_state(read_state_choice(command.from), scene, results.path(), until);
    }

    /// Null: the run starts from the beginning.
    [[nodiscard]] const FoundCheckpoint* checkpoint() const {
        if (to_start) return &to_start->checkpoint;
        return to_resume ? &*to_resume : nullptr;
    }
    /// Where the run has its first state from, now or before it was resumed.
    [[nodiscard]] std::optional<StartedFrom> started_from() const {
        if (!to_start) return to_resume ? to_resume->label.started_from : std::nullopt;
        const FoundCheckpoint& from = to_start->checkpoint;
        return StartedFrom{from.file.string(), from.step, from.time};
    }

    ResultsFolder results;
    double until;  ///< [s]
    std::optional<FoundCheckpoint> to_resume;
    std::optional<StartingState> to_start;
};

/// Removes what an earlier run has left, unless the run goes on: nothing refuses it any more. Returns what to say.
std::string open_folder(const Destination& destination) {
    const fs::path& folder = destination.results.path();
    std::string said = destination.results.note().empty() ? "" : destination.results.note() + "\n";
    if (const FoundCheckpoint* found = destination.checkpoint()) {
        for (const std::string& message : found->messages)
            said += Style(Stream::output).warning("warning: ") + message + "\n";
        if (const std::string note = version_note(*found); !note.empty()) said += note + "\n";
    }
    if (destination.to_start) said += text_of(*destination.to_start, destination.until);
    if (const auto& found = destination.to_resume)
        return said +
               fmt::format("Going on in {} from step {}, t = {:.6g} s\n\n", folder.string(), found->step, found->time);
    CheckpointFolder(folder).make();  // may refuse
    if (const std::string removed = remove_results(folder); !removed.empty()) said += removed + "\n";
    return said + "Writing to " + folder.string() + "\n\n";
}

/// ", by SIGTERM"
std::string stopped_by(const RunSummary& summary, const StopSignals& signals) {
    if (summary.out_of_time) return ", out of its wall time";
    const std::string name = signals.name();
    return name.empty() ? "" : ", by " + name;
}

/// The first rank, which speaks, writes and draws.
int run_as_first(const RunCommand& command, Prepared prepared, const Resources& resources, RunOptions options,
                 References references, Destination* destination) {
    const Scene& scene = prepared.scene;
    const std::string head = heading(prepared);
    const ParticleSet particles = command.dry_run ? prepared.particles : ParticleSet{};
    if (destination != nullptr) {
        if (const FoundCheckpoint* start = destination->checkpoint()) check_particles(*start, prepared.particles);
        options.checkpoints.label = {resolved_scene(scene), build_facts().version, fingerprint(prepared.particles),
                                     destination->started_from()};
    }
    std::optional<Simulation> simulation(std::in_place, scene, prepared.particles, resources);
    prepared.particles = {};
    Plan plan = simulation->plan();
    check_steps(scene, plan, options.until);
    const FoundCheckpoint* found = destination != nullptr ? destination->checkpoint() : nullptr;
    plan.steps = expected_steps(scene, plan.dt, options.until);
    if (found != nullptr) plan.steps -= expected_steps(scene, plan.dt, found->time);
    if (auto warning = frames_rule_steps(scene, plan)) plan.warnings.push_back(std::move(*warning));
    const Listing values = chosen_values(scene, plan, prepared.origin);
    const std::string chosen = head + "\n" + chosen_text(values) + "\n";
    print(chosen);
    flush_output();
    std::vector<std::string> warnings = prepared.origin.warnings;
    for (const Warning& warning : plan.warnings) warnings.push_back(warning.text());
    if (command.dry_run) {
        for (const std::string& warning : warnings)
            print_error(Style(Stream::error).warning("warning:") + " " + warning + "\n");
        simulation.reset();  // the trial has one of its own
        print(dry_run_text(scene, plan, try_out(scene, particles, resources, options.until, trial_of(command)),
                           options.until));
        return exit_done;
    }

    const fs::path& folder = destination->results.path();
    options.checkpoints.folder = folder;
    const bool goes_on = destination->to_resume.has_value();
    std::string checkpoint = found != nullptr ? found->file.string() : "";
    resources.ranks.broadcast(checkpoint);
    if (destination->to_start) simulation->start_from(checkpoint);  // may refuse: before anything in the folder changes
    const auto sink = frame_series(command, folder, scene, resources.ranks);
    const std::string opened = open_folder(*destination);
    const TypedCommand typed = command.typed.on_ranks(resources.ranks.size());
    RunLog log(folder, typed.text());
    log.add(chosen);
    for (const std::string& warning : warnings) log.warn(": " + warning);
    log.say(opened);
    if (goes_on) {
        const long frames = simulation->resume(checkpoint);
        if (sink) sink->go_on(frames);
        // They tell of an end that is none any more.
        remove_file(folder / summary_file_name);
        remove_file(folder / report_file_name);
        remove_file(folder / references_file_name);
    }

    const std::optional<StartedFrom> started_from = destination->started_from();
    write_scene_of_run(folder, scene, plan, resources, options.until, started_from);
    ProgressLine line;
    const StopSignals signals;
    options.sink = sink.get();
    options.progress = [&, start = WallClock::now()](const RunProgress& progress) {
        destination->results.check();
        const std::string logged = log.progress(progress, seconds_since(start));
        if (!logged.empty() && !is_terminal(Stream::error)) print_error(logged + "\n");
        line.show(progress);
    };
    options.warn = [&](double time, const Warning& warning) {
        line.clear();
        log.warn(" at " + quantity_text(time, "s") + ": " + warning.text());
        warnings.push_back(warning.text());
    };
    MeasuresFile measures(folder), references_file(folder, references_file_name);
    options.measured = [&](const MeasureSeries& series) {
        if (series.names.empty()) return;
        if (goes_on && !measures.is_begun())
            if (const std::string kept = keep_other_measures(folder, series); !kept.empty())
                log.say("What was measured before has other columns: it is kept in " + (folder / kept).string() + "\n");
        measures.write(series);
        if (const MeasureSeries& exact = references.at_times_of(series); !exact.names.empty())
            references_file.write(exact);
    };
    options.stop = &signals.flag();
    const RunSummary summary = simulate(*simulation, options, folder, log);
    line.clear();

    const std::vector<ReferenceDistance> distances = references.distances(summary.measures);
    log.say(summary_text(scene, summary) + distances_text(distances));
    // Before the pictures: a job that is being stopped may be killed while they are drawn.
    if (summary.interrupted)
        log.say(fmt::format("Stopped before its end{}. Go on with the same command and --resume.\n  {}\n",
                            stopped_by(summary, signals), typed.with("--resume")));
    const auto files = write_results(folder, scene, summary,
                                     {label_of(scene), sink ? sink->files() : std::vector<std::string>{}, started_from,
                                      values.lines(), plan.models, distances, warnings},
                                     command, line, log);
    // Of a run that goes on, those of before are still there.
    if (!summary.interrupted && !options.checkpoints.at_end) CheckpointFolder(folder).remove();
    log.say("\n" + results_text(folder, files));
    for (const Warning& warning : summary.warnings) log.warn(": " + warning.text());
    if (summary.out_of_time) return exit_out_of_time;
    return summary.interrupted ? signals.exit_code() : exit_done;
}

/// Any other rank.
int run_as_one_of_many(const RunCommand& command, Prepared prepared, const Resources& resources, RunOptions options) {
    const ParticleSet particles = command.dry_run ? prepared.particles : ParticleSet{};
    Simulation simulation(prepared.scene, prepared.particles, resources);
    prepared.particles = {};
    if (command.dry_run) {
        static_cast<void>(try_out(prepared.scene, particles, resources, options.until, trial_of(command)));
        return exit_done;
    }
    options.checkpoints.folder = output_folder(command.out, scene_name(prepared.scene));
    std::string checkpoint;
    resources.ranks.broadcast(checkpoint);
    if (!command.from.empty()) simulation.start_from(checkpoint);
    const auto sink = frame_series(command, options.checkpoints.folder, prepared.scene, resources.ranks);
    options.sink = sink.get();
    if (command.from.empty() && !checkpoint.empty()) {
        const long frames = simulation.resume(checkpoint);
        if (sink) sink->go_on(frames);
    }
    const StopSignals signals;
    options.stop = &signals.flag();
    simulation.run(options);
    return exit_done;
}

/// With the setting that a trade of the scene has found for the error that was asked for.
RunCommand with_known_setting(RunCommand command, bool is_told) {
    if (command.tolerance.empty()) {
        if (!command.trade.empty())
            throw InputError("--trade is the folder to look for a setting in",
                             "Say for which error: --tolerance \"5 %\".");
        return command;
    }
    const KnownSetting known = known_setting(command.scene, command.tolerance, command.trade, command.typed.program());
    command.scene = known.scene;
    if (is_told) print(known.text);
    return command;
}

}  // namespace

int execute(const RunCommand& asked) {
    const MpiSession session;
    return on_all_ranks(session, [&] {
        const RunCommand command = with_known_setting(asked, session.ranks().is_first());
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
        options.checkpoints.at_end = !command.left_out.contains(study::RunOutput::checkpoint);

        check_frames(scene, options.until);
        // Before particles are made, which may take long.
        References references(scene);
        std::optional<Destination> destination;
        if (resources.ranks.is_first() && !command.dry_run)
            destination.emplace(command, scene, output_folder(command.out, scene_name(scene)), options.until,
                                resources.ranks.size());
        Prepared prepared = prepare(std::move(scene), command.scene, resources.ranks);
        return resources.ranks.is_first() ? run_as_first(command, std::move(prepared), resources, options,
                                                         std::move(references), destination ? &*destination : nullptr)
                                          : run_as_one_of_many(command, std::move(prepared), resources, options);
    });
}

}  // namespace dmp::cli
