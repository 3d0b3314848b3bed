// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
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
#include "cli/scene_name.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/slurm_sweep.hpp"
#include "cli/sweep/sweep_budget.hpp"
#include "cli/sweep/sweep_dry_run.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_page.hpp"
#include "cli/sweep/sweep_rows.hpp"
#include "cli/sweep/sweep_runs.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/trade/trade_outcome.hpp"
#include "cli/trade/trade_request.hpp"
#include "cli/uses.hpp"
#include "report/trade_facts.hpp"
#include "study/read_study.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

/// Throws where the budget has ended before two settings could be compared.
void need_enough_budget(const TradeOutcome& outcome, const SweepBudget& budget, const TradeRequest& trade,
                        const TypedCommand& typed) {
    if (outcome.is_known()) return;
    std::string would = "not even one run has ended within it";
    std::vector<std::size_t> cheapest(std::min<std::size_t>(3, trade.settings.settings.size()));
    std::iota(cheapest.begin(), cheapest.end(), 0UL);
    if (const auto time = budget.expected(cheapest))
        would = fmt::format("the {} cheapest runs take about {} of one processor's time", cheapest.size(),
                            duration_text(*time));
    throw InputError({"--budget", 0, 0},
                     fmt::format("{} is too little to compare settings: {}", duration_text(*trade.budget), would),
                     "Give more, or a shorter run with --until, and go on:\n  " + typed.with("--resume"));
}

std::string left_text(const TradeRequest& trade, const SweepCounts& counts, const SweepBudget& budget,
                      const TradeOutcome& outcome, const TypedCommand& typed) {
    std::vector<std::size_t> left;
    for (std::size_t index = 0; index < outcome.settings.settings.size(); ++index)
        if (outcome.failures[index].empty() &&
            std::ranges::find(outcome.runs, index, &study::TradeRun::setting) == outcome.runs.end())
            left.push_back(index);
    const auto time = budget.expected(left);
    return fmt::format("\n{} not done within {}{}. With a larger --budget, go on:\n  {}\n",
                       count_text(counts.left(), "run"), duration_text(*trade.budget),
                       time && *time > 0 ? "; they would take about " + duration_text(*time) + " of one processor" : "",
                       typed.with("--resume"));
}

/// Tells and writes what is known when no more is run now. `left_in_queue`: what there is to say of jobs that go on.
/// Returns the exit code.
int close(const TradeCommand& command, const TradeRequest& trade, const SweepRows& rows, const SweepBudget& budget,
          const StopSignals& signals, const std::string& left_in_queue) {
    const fs::path& folder = rows.folder().path();
    TradeOutcome outcome = trade_outcome(folder, trade.read, trade.settings, rows.points(), trade.comparison);
    outcome.scene_path = command.scene;
    outcome.scene_name = scene_name(trade.read);
    outcome.identity = trade.identity;
    outcome.common = command.overrides;
    std::erase_if(outcome.common, [&](const std::string& each) { return trade.settings.sets(each); });
    outcome.until = *trade.read.run.duration;
    outcome.duration = trade.duration;
    if (outcome.is_known()) write_trade(folder, outcome);
    const std::string page = write_sweep_page(folder, rows.study(), rows.points());  // shows the trade, too
    if (outcome.is_known()) print(trade_text(outcome, trade.tolerances, command.typed.program()));
    Listing list;
    if (!page.empty()) list.add("look", page);
    if (outcome.is_known()) {
        list.add((folder / trade_picture_name).string(), "the picture of cost and error");
        list.add((folder / trade_file_name).string(), "all errors and costs, for programs");
    }
    list.add((folder / "runs").string(), "a folder for each run");
    print(Style(Stream::output).strong("Results") + "\n" + list.text());
    if (signals.flag()) {
        print(fmt::format("\nStopped before its end, by {}. Go on with the same command and --resume.\n  {}\n{}",
                          signals.name(), command.typed.with("--resume"), left_in_queue));
        return signals.exit_code();
    }
    const SweepCounts& counts = rows.counts();
    if (counts.left() > 0 && trade.budget) {
        need_enough_budget(outcome, budget, trade, command.typed);
        print(left_text(trade, counts, budget, outcome, command.typed));
    }
    if (counts.left() > 0 && !trade.budget)
        print(fmt::format("\n{} not done. Go on:\n  {}\n", count_text(counts.left(), "run"),
                          command.typed.with("--resume")));
    if (!outcome.is_known())
        throw InputError({folder.string(), 0, 0}, "fewer than two settings have come to their end",
                         "results.csv there says why.");
    return exit_done;
}

std::string threads_text(int threads) { return count_text(static_cast<std::size_t>(threads), "thread"); }

/// On this machine.
int run_here(const TradeCommand& command, const TradeRequest& trade, SweepRows& rows, SweepSettings settings) {
    const StopSignals signals;
    const SweepBudget budget(trade.budget, trade.settings.costs(), rows.points(), rows.folder().path(), settings.jobs,
                             settings.threads);
    settings.may_start = [&](std::size_t index) { return budget.may_start(index); };
    settings.stop_at = budget.end();
    SweepRuns(rows, settings).run(signals);
    return close(command, trade, rows, budget, signals, "");
}

int run_in_jobs(const TradeCommand& command, const TradeRequest& trade, SweepRows& rows, SlurmQueue queue,
                const SlurmSettings& settings) {
    const StopSignals signals;
    SlurmRuns runs(rows, std::move(queue), settings);
    runs.run(signals);
    const SweepBudget none({}, trade.settings.costs(), rows.points(), rows.folder().path(), 1, 1);
    return close(command, trade, rows, none, signals, runs.left_text());
}

/// What `dmp sweep` would be told of the study in the trade's folder.
SweepCommand as_sweep(const TradeCommand& command, const fs::path& out) {
    SweepCommand sweep;
    sweep.study = (out / study_copy_name).string();
    sweep.out = out.string();
    sweep.jobs = command.jobs;
    sweep.resume = command.resume;
    sweep.slurm = command.slurm;
    sweep.slurm_options = command.slurm_options;
    return sweep;
}

}  // namespace

int execute(const TradeCommand& command) {
    refuse_several_ranks();
    const TradeRequest trade = trade_request(command);
    const fs::path out = command.out.empty() ? default_trade_folder(trade.read) : output_folder(command.out, "");
    const study::Study study =
        study::parse_study(study::trade_study(trade.scene, trade.settings, out), (out / study_copy_name).string());
    const study::Points points(study);
    std::vector<std::size_t> all(points.size());
    std::iota(all.begin(), all.end(), 0UL);
    SweepSettings settings;
    settings.program = command.typed.program();
    settings.threads = std::max(1, *trade.read.run.threads);
    settings.jobs = runs_at_a_time(command.jobs, settings.threads);
    settings.left_out = study.left_out;
    const SlurmSettings slurm = slurm_settings(as_sweep(command, out), study, out);  // checks its options
    print(Style(Stream::output).strong(scene_name(trade.read)) + ": " + count_text(all.size(), "setting") + " of " +
          study.scene.file + "\n");
    if (!trade.added.empty())
        print("The scene measures nothing; its runs are compared by " + quoted_list(trade.added) + ".\n");
    if (command.dry_run) {
        print(settings_text(trade.settings));
        if (command.slurm) print(script_text(slurm, study, all.size()));
        flush_output();
        print(Style(Stream::output).strong("Dry run") + "\n" +
              cost_text(study, points, all, trade.settings.costs(), settings) + "Nothing was written.\n");
        return exit_done;
    }
    if (command.overwrite) need_no_queued_jobs(out);
    // A trade whose jobs are in the queue goes on there.
    const bool in_jobs = command.slurm || (command.resume && has_queued_jobs(out));
    if (in_jobs && trade.budget)
        throw InputError({"--budget", 0, 0}, "the jobs of this trade are in the queue of Slurm, which has no budget",
                         "Leave it out; --time is the limit of a job.");
    std::optional<SlurmQueue> queue;  // that there is one, before anything is written
    if (in_jobs) queue.emplace();
    const SweepFolder folder(out, {study, points.size(), command.resume, command.overwrite}, command.typed);
    print(folder.note() + fmt::format("Writing to {}, ", folder.path().string()) +
          (in_jobs ? fmt::format("in jobs of Slurm, on {} of {} each\n\n",
                                 count_text(static_cast<std::size_t>(*slurm.slurm.ranks), "rank"),
                                 threads_text(*slurm.slurm.threads))
                   : fmt::format("{} at a time on {} each\n\n", settings.jobs, threads_text(settings.threads))));
    flush_output();
    begin_sweep_page(folder.path(), study, points, command.typed);
    SweepRows rows(study, points, folder, all);
    if (queue) return run_in_jobs(command, trade, rows, std::move(*queue), slurm);
    return run_here(command, trade, rows, std::move(settings));
}

}  // namespace dmp::cli
