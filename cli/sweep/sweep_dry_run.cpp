// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_dry_run.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "cli/dry_run.hpp"
#include "cli/prepare.hpp"
#include "cli/run_bounds.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "scene/read_scene.hpp"
#include "solver/results/expected_steps.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

namespace {

constexpr std::size_t most_shown = 20;
constexpr double trial_seconds = 1;

/// Each of so many jobs takes the next run as soon as its last one has ended.
double time_of_all(const std::vector<double>& costs, int jobs) {
    std::vector<double> free_at(static_cast<std::size_t>(jobs), 0.0);
    for (const double cost : costs) *std::ranges::min_element(free_at) += cost;
    return std::ranges::max(free_at);
}

}  // namespace

double disk_of_run(std::size_t particles, double frames, bool pictures, const study::LeftOut& left_out) {
    using study::RunOutput;
    // As the runs of cases/carrier and cases/cilia have left them: compressed frames of all default fields, the last
    // two checkpoints; measures, log and summary; pictures, which are in the page, too.
    constexpr double frame_bytes = 80, checkpoint_bytes = 250, text_bytes = 33e3, page_bytes = 90e3,
                     picture_bytes = 500e3;
    const auto left = [&](RunOutput output) { return !left_out.contains(output); };
    const bool drawn = pictures && left(RunOutput::frames) && left(RunOutput::pictures);
    const auto all = static_cast<double>(particles);
    double bytes = text_bytes;
    if (left(RunOutput::frames)) bytes += frames * frame_bytes * all;
    if (left(RunOutput::checkpoint)) bytes += 2 * checkpoint_bytes * all;
    if (drawn) bytes += picture_bytes;
    if (left(RunOutput::page)) bytes += page_bytes + (drawn ? picture_bytes : 0);
    return bytes;
}

std::string runs_text(const study::Study& study, const study::Points& points, const std::vector<std::size_t>& chosen) {
    std::vector<std::vector<std::string>> rows(1, {"run"});
    for (const study::VariedKey& key : study.keys()) rows[0].push_back(csv_heading(*key.key, key.unit));
    for (std::size_t k = 0; k < std::min(most_shown, chosen.size()); ++k) {
        const study::Point point = points.at(chosen[k]);
        std::vector<std::string>& row = rows.emplace_back(1, point.name);
        for (const study::VariedValue& value : point.values) row.push_back(value.cell);
    }
    std::string text = table_text(rows);
    if (chosen.size() > most_shown) text += fmt::format("  ... and {} more\n", count_text(chosen.size() - most_shown));
    return text;
}

std::string cost_text(const study::Study& study, const study::Points& points, const std::vector<std::size_t>& chosen,
                      const std::vector<double>& costs, const SweepSettings& settings) {
    const study::Point first = points.at(chosen.front());
    SceneChoice choice;
    choice.path = study.scene.file;
    choice.overrides = study::overrides(study, first);
    Resources resources;
    resources.threads = settings.threads;
    Scene scene = read_scene(choice.path, choice.overrides);
    const double until = *scene.run.duration;
    check_frames(scene, until);
    const Prepared prepared = prepare(std::move(scene), choice, resources.ranks);
    const Plan plan = Simulation(prepared.scene, prepared.particles, resources).plan();
    check_steps(prepared.scene, plan, until);
    const Trial trial = try_out(prepared.scene, prepared.particles, resources, until, trial_seconds);

    const auto steps = static_cast<double>(expected_steps(prepared.scene, plan.dt, until));
    const double seconds = steps * trial.seconds_per_step;
    const auto runs = static_cast<double>(chosen.size());
    const double frames = expected_frames(prepared.scene, until);
    Listing list;
    list.add("a run", fmt::format("about {} of computing, as {} takes: {} of {}", duration_text(seconds), first.name,
                                  count_text(static_cast<std::size_t>(steps), "step"), quantity_text(plan.dt, "s")));
    list.add("all runs", fmt::format("about {}, {} at a time on {} each",
                                     duration_text(seconds * time_of_all(costs, settings.jobs)), settings.jobs,
                                     count_text(static_cast<std::size_t>(settings.threads), "thread")));
    list.add("memory",
             fmt::format("about {}, {} a run", bytes_text(trial.peak_memory * std::min<double>(settings.jobs, runs)),
                         bytes_text(trial.peak_memory)));
    if (!settings.left_out.contains(study::RunOutput::frames))
        list.add("frames", fmt::format("{} a run, {} in all", count_text(static_cast<std::size_t>(frames)),
                                       count_text(static_cast<std::size_t>(frames * runs))));
    const double disk =
        disk_of_run(prepared.particles.size(), frames, *prepared.scene.output.pictures, settings.left_out);
    std::error_code unknown;
    const std::filesystem::space_info space = std::filesystem::space(std::filesystem::current_path(), unknown);
    list.add("disk", fmt::format("about {}, {} a run{}", bytes_text(disk * runs), bytes_text(disk),
                                 unknown ? "" : "; " + bytes_text(static_cast<double>(space.available)) + " are free"));
    list.add("", "runs with other values may take longer or shorter; frames and pictures come on top of the time");
    return list.text();
}

}  // namespace dmp::cli
