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
#include "cli/limits/limits_outcome.hpp"
#include "cli/limits/limits_request.hpp"
#include "cli/limits/rung_ends.hpp"
#include "cli/machine.hpp"
#include "cli/output_folder.hpp"
#include "cli/prepare.hpp"
#include "cli/scene_name.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/sweep_budget.hpp"
#include "cli/sweep/sweep_dry_run.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_page.hpp"
#include "cli/sweep/sweep_rows.hpp"
#include "cli/sweep/sweep_runs.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "report/limits_facts.hpp"
#include "study/limit_bisection.hpp"
#include "study/read_study.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;
using study::LimitStudy;

/// Which runs the search needs, of those that have ended.
class Search {
  public:
    Search(const LimitsRequest& request, RungEnds& ends) : request_(request), ends_(ends) {}

    /// Whether a run is the next one that its dial needs.
    [[nodiscard]] bool needs(std::size_t run) {
        if (run == LimitStudy::own) return true;
        if (ends_.of(LimitStudy::own).way != RungWay::clean) return false;
        const auto place = request_.study.place_of(run);
        if (!place) return true;
        return ends_.has_reference() && request_.asked[place->dial] && ends_.can_compare(place->dial) &&
               study::next_rung(ends_.states_of(place->dial)) == place->rung;
    }

    /// How many runs it takes until all limits are known, at most.
    [[nodiscard]] std::size_t most_left() {
        const RungWay own = ends_.of(LimitStudy::own).way;
        if (own != RungWay::clean && own != RungWay::unknown) return 0;
        std::size_t left = own == RungWay::unknown ? 1 : 0;
        if (request_.study.repeat() && ends_.of(*request_.study.repeat()).way == RungWay::unknown) ++left;
        const bool is_known = ends_.has_reference();
        for (std::size_t dial = 0; dial < request_.asked.size(); ++dial)
            if (request_.asked[dial] && (!is_known || ends_.can_compare(dial)))
                left += study::most_runs_left(ends_.states_of(dial));
        return left;
    }

  private:
    const LimitsRequest& request_;
    RungEnds& ends_;
};

/// Throws what the run with the scene's own settings has ended with.
void need_own_run(const RungEnd& own, const fs::path& folder, const std::string& run) {
    const std::string problem = "the scene does not run at its own settings: " + own.text;
    const std::string to_do = "Its limits begin there: " + run_folder(folder, run).string() + " has the run.";
    switch (own.way) {
        case RungWay::unknown:
        case RungWay::clean:
        case RungWay::departs:
            return;
        case RungWay::breaks:
            throw DivergenceError(problem, to_do);
        case RungWay::refused:
            throw InputError(problem, to_do);
        case RungWay::failed:
            throw ResourceError(problem, to_do);
    }
}

std::string time_text(const SweepBudget& budget, std::size_t runs) {
    const auto time = budget.expected(std::vector<std::size_t>(runs, LimitStudy::own));
    return time && *time > 0 ? "; they take about " + duration_text(*time) + " of one processor" : "";
}

/// Tells and writes what is known when no more is run now. Returns the exit code.
int close(const LimitsCommand& command, const LimitsRequest& request, const SweepRows& rows, RungEnds& ends,
          const SweepBudget& budget, const StopSignals& signals) {
    const fs::path& folder = rows.folder().path();
    const bool is_known = ends.has_reference();
    const LimitsFacts limits = limits_found(request, command.scene, ends, rows.points());
    if (is_known) write_limits(folder, limits);
    const std::string page = write_sweep_page(folder, rows.study(), rows.points());  // shows the limits, too
    need_own_run(ends.of(LimitStudy::own), folder, limits.own_run);
    if (is_known) print(limits_text(limits));
    Listing list;
    if (!page.empty()) list.add("look", page);
    if (is_known) {
        list.add((folder / limits_picture_name).string(), "the picture of the limits");
        list.add((folder / limits_file_name).string(), "all of them, for programs");
    }
    list.add((folder / "runs").string(), "a folder for each run");
    print(Style(Stream::output).strong("Results") + "\n" + list.text());
    const std::size_t left = Search(request, ends).most_left();
    if (signals.flag()) {
        print(fmt::format("\nStopped before its end, by {}. Go on with the same command and --resume.\n  {}\n",
                          signals.name(), command.typed.with("--resume")));
        return signals.exit_code();
    }
    if (left == 0) return exit_done;
    const std::string left_text = count_text(left, "run") + " at most" + time_text(budget, left);
    if (!is_known && request.budget)
        throw InputError(
            {"--budget", 0, 0},
            duration_text(*request.budget) + " is too little to find a limit: it takes " + left_text,
            "Give more, a shorter run with --until, or fewer dials, and go on:\n  " + command.typed.with("--resume"));
    if (!is_known)  // without a budget and a signal, all that is needed has been run
        throw ResourceError("the runs with the scene's own settings did not come to their end",
                            "Go on with the same command and --resume:\n  " + command.typed.with("--resume"));
    print(fmt::format("\nNot done: {}. {}\n  {}\n", left_text,
                      request.budget ? "With a larger --budget, go on:" : "Go on:", command.typed.with("--resume")));
    return exit_done;
}

/// All but those whose end is known of an earlier start: the way they failed is what was looked for.
std::vector<std::size_t> runs_to_choose(const study::Points& points, const fs::path& folder) {
    const auto failures = earlier_failures(folder / sweep_results_name);
    std::vector<std::size_t> chosen;
    for (std::size_t run = 0; run < points.size(); ++run) {
        const auto failure = failures.find(points.at(run).name);
        const bool is_known = failure != failures.end() && (failure->second.exit_code == exit_diverged ||
                                                            failure->second.exit_code == exit_bad_input);
        if (!is_known) chosen.push_back(run);
    }
    return chosen;
}

std::string dry_run(const LimitsRequest& request, const study::Study& study, const study::Points& points,
                    const SweepSettings& settings) {
    std::size_t most = request.study.repeat() ? 2 : 1;
    for (std::size_t dial = 0; dial < request.asked.size(); ++dial)
        if (request.asked[dial])
            most +=
                study::most_runs_left(std::vector(request.study.dials()[dial].rungs.size(), study::RungState::unknown));
    // As if all took what the first one takes.
    const std::vector<std::size_t> runs(most, LimitStudy::own);
    return Style(Stream::output).strong("Dry run") + "\n" +
           cost_text(study, points, runs, std::vector<double>(most, 1), settings) + "Nothing was written.\n";
}

}  // namespace

int execute(const LimitsCommand& command) {
    refuse_several_ranks();
    const LimitsRequest request = limits_request(command);
    const fs::path out = command.out.empty() ? default_limits_folder(request.read) : output_folder(command.out, "");
    const std::string title = request.read.title->empty() ? command.scene : *request.read.title;
    const study::Study study = study::parse_study(request.study.text(command.scene, title, request.overrides, out),
                                                  (out / study_copy_name).string());
    const study::Points points(study);
    SweepSettings settings;
    settings.program = command.typed.program();
    settings.threads = std::max(1, *request.read.run.threads);
    settings.jobs = runs_at_a_time(command.jobs, settings.threads);
    settings.left_out = study.left_out;
    print(Style(Stream::output).strong(scene_name(request.read)) +
          fmt::format(": {} of {}, by runs of {} (about {})\n",
                      count_text(static_cast<std::size_t>(std::ranges::count(request.asked, true)), "limit"),
                      study.scene.file, duration_text(*request.read.run.duration),
                      count_text(static_cast<std::size_t>(request.steps), "step")));
    if (!request.added.empty())
        print("The scene measures nothing; its runs are compared by " + quoted_list(request.added) + ".\n");
    if (command.dry_run) {
        print(dials_text(request));
        flush_output();
        print(dry_run(request, study, points, settings));
        return exit_done;
    }
    const SweepFolder folder(out, {study, points.size(), command.resume, command.overwrite}, command.typed);
    print(folder.note() + fmt::format("Writing to {}, {} at a time on {} each\n\n", folder.path().string(),
                                      settings.jobs, count_text(static_cast<std::size_t>(settings.threads), "thread")));
    flush_output();
    begin_sweep_page(folder.path(), study, points, command.typed);
    const StopSignals signals;
    SweepRows rows(study, points, folder, runs_to_choose(points, folder.path()));
    RungEnds ends(rows, request.study, request.read, request.tolerance);
    Search search(request, ends);
    const SweepBudget budget(request.budget, request.study.costs(), points, folder.path(), settings.jobs,
                             settings.threads);
    settings.may_start = [&](std::size_t run) {
        rows.counts().runs = rows.counts().done + rows.counts().failed + search.most_left();
        return search.needs(run) && budget.may_start(run);
    };
    settings.stop_at = budget.end();
    SweepRuns(rows, settings).run(signals);
    return close(command, request, rows, ends, budget, signals);
}

}  // namespace dmp::cli
