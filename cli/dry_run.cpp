// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/dry_run.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "cli/chosen.hpp"
#include "cli/process_memory.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "solver/results/expected_steps.hpp"

namespace dmp::cli {

namespace {

/// Sets a flag after a while, unless it is destroyed before.
class Alarm {
  public:
    Alarm(double seconds, std::atomic<bool>& flag)
        : thread_([this, seconds, &flag](const std::stop_token& ended) {
              std::unique_lock lock(mutex_);
              const auto wait = std::chrono::duration<double>(seconds);
              changed_.wait_for(lock, ended, wait, [] { return false; });
              flag = true;
          }) {}

  private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::jthread thread_;  // last: it uses the others
};

std::size_t total_of(const Plan& plan) {
    std::size_t total = 0;
    for (const auto& [kind, count] : plan.particles) total += count;
    return total;
}

}  // namespace

Trial try_out(const Scene& scene, const ParticleSet& particles, const Resources& resources, double until,
              double budget) {
    Simulation simulation(scene, particles, resources);
    std::atomic<bool> stop = false;
    RunSummary summary;
    {
        const Alarm alarm(budget, stop);
        RunOptions options;
        options.until = until;
        options.stop = &stop;
        summary = simulation.run(options);
    }
    const auto steps = static_cast<double>(std::max(1L, summary.steps));
    const auto memory = resources.ranks.sum(static_cast<std::int64_t>(own_memory().most));
    return {summary.steps, summary.wall_s / steps, static_cast<double>(memory)};
}

std::string dry_run_text(const Scene& scene, const Plan& plan, const Trial& trial, double until) {
    const auto steps = static_cast<double>(expected_steps(scene, plan.dt, until));
    const double frames = expected_frames(scene, until);
    Listing list;
    for (const auto& [kind, count] : plan.particles) list.add(kind, count_text(count, "particle"));
    list.add("memory",
             fmt::format("{} for the particles ({} each); the trial took {} in all",
                         bytes_text(static_cast<double>(plan.bytes_per_particle * total_of(plan))),
                         bytes_text(static_cast<double>(plan.bytes_per_particle)), bytes_text(trial.peak_memory)));
    list.add("time", fmt::format("{:.4g} s in about {} of about {}", until,
                                 count_text(static_cast<std::size_t>(steps), "step"), quantity_text(plan.dt, "s")));
    list.add("frames", count_text(static_cast<std::size_t>(frames)));
    list.add("takes", fmt::format("about {} of computing: {} a step, measured here over {}",
                                  duration_text(steps * trial.seconds_per_step), duration_text(trial.seconds_per_step),
                                  count_text(static_cast<std::size_t>(trial.steps), "step")));
    list.add("", "frames and pictures come on top; other work on this machine slows it down");
    return limits_text(plan) + Style(Stream::output).strong("Dry run") + "\n" + list.text() + "Nothing was written.\n";
}

}  // namespace dmp::cli
