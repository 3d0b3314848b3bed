// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_bounds.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/text.hpp"

namespace dmp::cli {

namespace {

constexpr double most_frames = 1e6, most_rows = 1e8, most_steps = 1e12;

}  // namespace

void check_frames(const Scene& scene, double until) {
    const Value<double>& every = scene.output.every;
    const double frames = until / every;
    if (!(frames <= most_frames))
        throw InputError(
            every.location,
            fmt::format("output.every: {} s in frames {} s apart are {:.2g} frames, more than the {:.0e} that "
                        "dmp writes",
                        until, *every, frames, most_frames),
            "Give a longer output.every, or run less time.");
    const Value<double>& measured = scene.output.measure_every;
    if (!scene.measures.empty() && *measured > 0 && !(until / measured <= most_rows))
        throw InputError(
            measured.location,
            fmt::format("output.measure_every: {} s in rows {} s apart are {:.2g} rows of measures.csv, more "
                        "than the {:.0e} that dmp writes",
                        until, *measured, until / measured, most_rows),
            "Give a longer output.measure_every, or run less time.");
}

void check_steps(const Scene& scene, const Plan& plan, double until) {
    const double steps = until / plan.dt;
    if (steps <= most_steps) return;
    const auto ruling = std::ranges::find(plan.limits, plan.ruling_limit, &StepLimit::model);
    throw InputError(
        until == *scene.run.duration ? scene.run.duration.location : SourceLocation{"--until", 0, 0},
        fmt::format("{} would take {:.2g} steps of {}, ruled by {}{}, more than the {:.0e} that dmp runs, 12 days at a "
                    "microsecond a step",
                    quantity_text(until, "s"), steps, quantity_text(plan.dt, "s"), plan.ruling_limit,
                    ruling == plan.limits.end() ? "" : " (" + ruling->formula + ")", most_steps),
        fmt::format("Run at most {}, or check the values behind that limit; 'dmp explain SCENE' lists all limits.",
                    quantity_text(most_steps * plan.dt, "s")));
}

std::optional<Warning> frames_rule_steps(const Scene& scene, const Plan& plan) {
    const Value<double>& every = scene.output.every;
    if (*every >= plan.dt) return std::nullopt;
    return Warning{"output.every", every.location,
                   fmt::format("is shorter than the time step, {}: each step writes a frame, and takes only as long",
                               quantity_text(plan.dt, "s")),
                   "give a longer one"};
}

}  // namespace dmp::cli
