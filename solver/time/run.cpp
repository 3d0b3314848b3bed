// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/run.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <vector>

#include "base/number_text.hpp"
#include "base/wall_clock.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

namespace {

/// A step may exceed its limit by this, relatively, where another one would have to be taken otherwise.
constexpr double slack = 1e-6;

/// Of the ranks' texts, that of the lowest rank whose text is not empty.
std::string first_that_is_not_empty(const Ranks& ranks, const std::string& text) {
    const std::vector<char> own(text.begin(), text.end());
    const std::int64_t mine = text.empty() ? ranks.size() : ranks.rank();
    const auto lowest = static_cast<std::int64_t>(ranks.smallest(static_cast<double>(mine)));
    const auto all = ranks.all_gather(lowest == ranks.rank() ? own : std::vector<char>());
    return {all.begin(), all.end()};
}

}  // namespace

void Run::load(const Hdf5Reader& checkpoint, LoadedFor purpose) {
    Archive file(ranks(), checkpoint, purpose);
    archive(file);
    if (step() < 0 || frames() < 0) throw unlike_any_run("fewer than no steps or frames");
}

long Run::resume(const Hdf5Reader& checkpoint) {
    load(checkpoint, LoadedFor::going_on);
    return frames();
}

void Run::start_from(const Hdf5Reader& checkpoint) {
    load(checkpoint, LoadedFor::new_run);
    starts_from_state_ = true;
}

RunSummary Run::run(const RunOptions& options) {
    const double until = options.until > 0 ? options.until : duration();
    Checkpoints checkpoints(ranks(), options.checkpoints);
    const std::int64_t first_step = step();
    start(options.sink);
    if (options.measured) options.measured(series());
    const std::clock_t processor = std::clock();
    const End end = step_until(checkpoints, options, until);
    ExactSum processor_s;
    processor_s.add(static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
    ranks().sum(processor_s);
    finish(options.sink);

    RunSummary summary = this->summary();
    const Plan plan = this->plan();
    summary.limits = plan.limits;
    summary.ruling_limit = plan.ruling_limit;
    summary.wall_s = end.wall;
    std::size_t particles = 0;
    for (const auto& [kind, count] : plan.particles) particles += count;
    const std::int64_t steps = step() - first_step;
    summary.particle_steps_per_s = static_cast<double>(steps) * static_cast<double>(particles) / end.wall;
    summary.processor_s =
        steps == 0 ? 0 : processor_s.value() * static_cast<double>(step()) / static_cast<double>(steps);
    summary.interrupted = end.interrupted;
    summary.out_of_time = end.out_of_time;
    summary.first_step = static_cast<long>(first_step);
    summary.shares = shares(steps);
    return summary;
}

Run::End Run::step_until(Checkpoints& checkpoints, const RunOptions& options, double until) {
    const auto save = [&] { checkpoints.save(step(), [&](Archive& file) { archive(file); }); };
    const auto start = WallClock::now();
    auto last_progress = start;
    End end;
    const double last = until * (1 - 1e-12);
    const std::int64_t first_step = step();
    bool depends_on_end = false;  // the state
    while (time() < last && !finished()) {
        Step step = next_step(options);
        const bool is_near_end = is_shaped_by_end(step, until);
        // However short the limit, a run that is started again and again comes to its end.
        const bool out_of_time =
            options.wall_limit > 0 && this->step() > first_step && seconds_since(start) > options.wall_limit;
        // What one rank asks for, all ranks do.
        std::array<double, 3> requests{options.stop != nullptr && *options.stop ? 1.0 : 0.0, out_of_time ? 1.0 : 0.0,
                                       checkpoints.due() ? 1.0 : 0.0};
        ranks().largest(requests);
        // Without a checkpoint of these last two steps they would be lost with all before them.
        const bool may_stop = options.checkpoints.at_end || !depends_on_end;
        end.out_of_time = may_stop && requests[1] > 0;
        end.interrupted = may_stop && (requests[0] > 0 || end.out_of_time);
        // A longer run does not pass through a state that depends on the end.
        const bool is_last = is_near_end && options.checkpoints.at_end;
        if (checkpoints.wanted() && !depends_on_end && (end.interrupted || is_last || requests[2] > 0)) save();
        if (end.interrupted) break;
        if (is_near_end) step = towards_end(step, until);
        depends_on_end = depends_on_end || is_near_end;
        const std::size_t rows = series().rows.size();
        advance(options, step);
        if (options.measured && series().rows.size() > rows) options.measured(series());
        if (options.progress && ranks().is_first() && seconds_since(last_progress) > 0.2) {
            last_progress = WallClock::now();
            options.progress(progress(until));
        }
    }
    if (checkpoints.wanted() && options.checkpoints.at_end && !depends_on_end && !end.interrupted &&
        step() > first_step)
        save();
    // The last state gets a frame and a row of measures, also where none is due.
    write_frame(options.sink);
    if (series().time.empty() || series().time.back() < time()) {
        take_measures();
        if (options.measured) options.measured(series());
    }
    end.wall = seconds_since(start);
    return end;
}

/// Whether the run ends within two such steps, and before what the step leads to.
bool Run::is_shaped_by_end(const Step& step, double until) const {
    return until < step.target && until - time() <= 2 * step.dt * (1 + slack);
}

Run::Step Run::towards_end(const Step& step, double until) const {
    const double left = until - time();
    return {left <= step.dt * (1 + slack) ? left : left / 2, until};
}

void Run::stop_on_violation(FrameSink* sink, const std::string& found) {
    const std::string first = first_that_is_not_empty(ranks(), found);
    if (first.empty()) return;
    const auto end = first.find('\n');
    diverged(sink, first.substr(0, end), first.substr(end + 1));
}

void Run::diverged(FrameSink* sink, const std::string& problem, const std::string& what_to_do) {
    write_diverged_frame(sink);
    const bool written = ranks().any(sink != nullptr);  // a trial writes nothing
    throw DivergenceError(
        "the simulation diverged at t = " + number_text(time()) + " s, step " + std::to_string(step()) + ": " + problem,
        what_to_do + (written ? "\nThe last frame shows the state" : ""));
}

}  // namespace dmp::solver
