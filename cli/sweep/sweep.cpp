// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/nearest_name.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/machine.hpp"
#include "cli/output_folder.hpp"
#include "cli/prepare.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/run_words.hpp"
#include "cli/sweep/slurm_sweep.hpp"
#include "cli/sweep/sweep_choice.hpp"
#include "cli/sweep/sweep_dry_run.hpp"
#include "cli/sweep/sweep_element.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_page.hpp"
#include "cli/sweep/sweep_rows.hpp"
#include "cli/sweep/sweep_runs.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "study/read_study.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Threads of each run: many runs at a time with one thread each take less time than few with more.
int threads_of(const study::Study& study) { return std::max(1, *study.scene.run.threads); }

std::string left_out_text(const study::Study& study, const study::LeftOut& left_out) {
    if (left_out.empty()) return "";
    std::vector<std::string> names;
    for (const study::RunOutput each : left_out) names.push_back(to_string(each));
    return "The runs leave out " + quoted_list(names) +
           (study.left_out.given()
                ? "\n"
                : fmt::format(", as they are more than {}; 'leave_out = []' in the study keeps all\n",
                              study::most_runs_with_pages));
}

std::string heading_of(const study::Study& study, std::size_t chosen, std::size_t all) {
    const std::string runs =
        chosen == all ? count_text(all, "run") : fmt::format("{} of {}", count_text(chosen), count_text(all, "run"));
    return Style(Stream::output).strong(study.name) + ": " + runs + " of " + study.scene.file + "\n";
}

/// The rows of the chosen runs that have ended, in order.
std::vector<SweepRow> ended_rows(const SweepTable& table, const std::vector<std::size_t>& chosen) {
    const auto rows = table.rows();
    std::vector<SweepRow> ended;
    for (const std::size_t index : chosen)
        if (rows[index]) ended.push_back(*rows[index]);
    return ended;
}

/// Which runs failed, and why; the first ones.
std::string failures_text(const std::vector<SweepRow>& ended) {
    constexpr std::size_t most = 10;
    std::string text;
    std::size_t failed = 0;
    for (const SweepRow& row : ended) {
        if (!row.failed()) continue;
        if (++failed <= most) text += fmt::format("  {}  code {}: {}\n", row.run, row.exit_code, row.error);
    }
    if (failed > most) text += fmt::format("  ... and {} more\n", count_text(failed - most));
    return failed == 0 ? "" : Style(Stream::output).strong("Failed") + "\n" + text;
}

/// `page`: what to say of the study's page; "": there is none.
std::string files_text(const fs::path& folder, const std::string& page) {
    Listing list;
    if (!page.empty()) list.add("look", page);
    list.add((folder / sweep_results_name).string(), "a row for each run that has ended");
    list.add((folder / sweep_timing_name).string(), "what each run took");
    list.add((folder / "runs").string(), "a folder for each run");
    return Style(Stream::output).strong("Results") + "\n" + list.text();
}

/// That of the first run that failed; of a run whose results could not be had, that of bad input.
int exit_code_of_runs(const std::vector<SweepRow>& ended) {
    for (const SweepRow& row : ended)
        if (row.failed()) return row.exit_code == exit_done ? exit_bad_input : row.exit_code;
    return exit_done;
}

/// A study has come as far as it can: writes its page, tells how it has ended, and returns the exit code. `left`: what
/// there is to say of runs that go on without this process.
int close(const SweepRows& rows, const StopSignals& signals, const TypedCommand& typed, const std::string& left) {
    const SweepCounts& counts = rows.counts();
    const fs::path& folder = rows.folder().path();
    print(fmt::format("{}: {} of {} done{}\n", counts.left() == 0 ? "Done" : "Interrupted", count_text(counts.done),
                      count_text(counts.runs, "run"),
                      counts.failed == 0 ? "" : ", " + count_text(counts.failed) + " failed"));
    const std::vector<SweepRow> ended = ended_rows(rows.table(), rows.chosen());
    const std::string page = write_sweep_page(folder, rows.study(), rows.points());
    print(failures_text(ended) + files_text(folder, page));
    if (counts.left() == 0) return exit_code_of_runs(ended);
    print(fmt::format("\nStopped before its end, by {}. Go on with the same command and --resume.\n  {}\n{}",
                      signals.name(), typed.with("--resume"), left));
    return signals.exit_code();
}

int in_jobs(const SweepCommand& command, const study::Study& study, const study::Points& points,
            const std::vector<std::size_t>& chosen, const SlurmSettings& settings) {
    SlurmQueue queue;  // that there is one, before anything is written
    const SweepFolder folder(settings.out, {study, points.size(), command.resume, command.overwrite}, command.typed);
    print(folder.note() + fmt::format("Writing to {}, in jobs of Slurm, on {} of {} each\n\n", folder.path().string(),
                                      count_text(static_cast<std::size_t>(*settings.slurm.ranks), "rank"),
                                      count_text(static_cast<std::size_t>(*settings.slurm.threads), "thread")));
    flush_output();
    begin_sweep_page(folder.path(), study, points, command.typed);
    const StopSignals signals;
    SweepRows rows(study, points, folder, chosen);
    SlurmRuns runs(rows, std::move(queue), settings);
    runs.run(signals);
    return close(rows, signals, command.typed, runs.left_text());
}

}  // namespace

int execute(const SweepCommand& command) {
    refuse_several_ranks();
    if (!command.runs.empty()) return do_runs(command);
    const study::Study study = study::read_study(command.study, command.overrides);
    const study::Points points(study);
    const fs::path out = output_folder(command.out, study.name);
    SweepSettings settings;
    settings.program = command.typed.program();
    settings.threads = threads_of(study);
    settings.jobs = runs_at_a_time(command.jobs, settings.threads);
    const std::vector<std::size_t> chosen = chosen_runs(study, points, command.only);
    const SlurmSettings slurm = slurm_settings(command, study, out);  // checks its options
    settings.left_out = left_out_of(study, points.size());
    print(heading_of(study, chosen.size(), points.size()));
    if (command.dry_run) {
        print(runs_text(study, points, chosen) + "\n");
        if (command.slurm) print(script_text(slurm, study, chosen.size()));
        flush_output();
        print(Style(Stream::output).strong("Dry run") + "\n" +
              cost_text(study, points, chosen, std::vector<double>(chosen.size(), 1), settings) +
              left_out_text(study, settings.left_out) + "Nothing was written.\n");
        return exit_done;
    }
    if (command.overwrite) need_no_queued_jobs(out);
    // A study whose jobs are in the queue goes on there.
    if (command.slurm || (command.resume && has_queued_jobs(out)))
        return in_jobs(command, study, points, chosen, slurm);
    const SweepFolder folder(out, {study, points.size(), command.resume, command.overwrite}, command.typed);
    print(folder.note() + left_out_text(study, settings.left_out) +
          fmt::format("Writing to {}, {} at a time on {} each\n\n", folder.path().string(), settings.jobs,
                      count_text(static_cast<std::size_t>(settings.threads), "thread")));
    flush_output();
    begin_sweep_page(folder.path(), study, points, command.typed);
    const StopSignals signals;
    SweepRows rows(study, points, folder, chosen);
    SweepRuns runs(rows, settings);
    runs.run(signals);
    return close(rows, signals, command.typed, "");
}

}  // namespace dmp::cli
