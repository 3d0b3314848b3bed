// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/chosen.hpp"
#include "cli/commands.hpp"
#include "cli/dry_run.hpp"
#include "cli/exit_codes.hpp"
#include "cli/output_folder.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/stop_signals.hpp"
#include "cli/summary_text.hpp"
#include "cli/terminal.hpp"
#include "postproc/pictures.hpp"
#include "postproc/safe_file.hpp"
#include "postproc/tables.hpp"
#include "postproc/vtk_sink.hpp"
#include "scene/read_scene.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Wall time of the trial that a dry run's estimate rests on [s].
constexpr double trial_seconds = 1.0;

/// The time to stop at [s].
double end_time(const Scene& scene, const std::string& until) {
    if (until.empty()) return scene.run.duration;
    const Place place{"--until", 0, 0};
    const double time = read_quantity(until, "s", place);
    if (!(time > 0)) {
        throw InputError(place, "'" + until + "' is no time to run to", "Give a time after 0, e.g. --until \"0.2 s\".");
    }
    return time;
}

Pictures draw(const Scene& scene, const fs::path& folder, ProgressLine& line) {
    if (!*scene.output.pictures) return {};
    line.show("drawing pictures");
    Pictures result = write_pictures(folder, {.field = word(*scene.output.picture_field)});
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

/// Everything the run leaves besides the frames; returns the files' names.
std::vector<std::string> write_results(const fs::path& folder, const Scene& scene, const RunSummary& summary,
                                       const VtkSink& sink, ProgressLine& line) {
    std::vector<std::string> files = sink.files();
    files.emplace_back(resolved_scene_name);
    if (!summary.measures.names.empty()) {
        write_measures_csv(folder, summary.measures);
        files.emplace_back(measures_file_name);
    }
    files.emplace_back(summary_file_name);
    // Before the pictures, so that whoever stops those has the numbers.
    write_summary(folder, summary, {label_of(scene), files});
    if (summary.interrupted) return files;

    const Pictures pictures = draw(scene, folder, line);
    files.insert(files.end(), pictures.files.begin(), pictures.files.end());
    write_summary(folder, summary, {label_of(scene), files});
    if (!pictures.warning.empty()) print(Style(Stream::output).warning("warning: ") + pictures.warning + "\n");
    return files;
}

}  // namespace

int execute(const RunCommand& command) {
    refuse_several_ranks();
    const VectorUnit vector_unit = chosen_vector_unit(command.vector_unit);
    Prepared prepared = prepare(command.scene);
    const Scene& scene = prepared.scene;
    const double until = end_time(scene, command.until);
    Resources resources(threads_for(scene, command.threads));
    resources.vector_unit = vector_unit;
    const std::string head = heading(prepared);

    const ParticleSet particles = command.dry_run ? prepared.mesh.particles : ParticleSet{};
    Simulation simulation(scene, prepared.mesh.particles, resources);
    prepared.mesh.particles = {};
    const Plan plan = simulation.plan();
    print(head + "\n" + chosen_text(scene, plan, prepared.mesh.report) + "\n");
    if (command.dry_run) {
        flush_output();
        print(dry_run_text(scene, plan, try_out(scene, particles, resources, until, trial_seconds), until));
        return exit_done;
    }

    const fs::path folder = output_folder(command.out, scene_name(scene));
    const std::string removed = prepare_folder(folder);
    if (!removed.empty()) print(removed + "\n");
    print("Writing to " + folder.string() + "\n\n");
    flush_output();

    write_file(folder / resolved_scene_name, resolved_scene(scene));
    VtkSink sink(folder, label_of(scene));
    ProgressLine line;
    const StopSignals signals;
    RunOptions options;
    options.until = until;
    options.sink = &sink;
    options.progress = [&line](const RunProgress& progress) { line.show(progress); };
    options.stop = &signals.flag();
    const RunSummary summary = simulate(simulation, options, folder);
    line.clear();

    print(summary_text(scene, summary));
    flush_output();
    const auto files = write_results(folder, scene, summary, sink, line);
    print("\n" + results_text(folder, files));
    return summary.interrupted ? signals.exit_code() : exit_done;
}

}  // namespace dmp::cli
