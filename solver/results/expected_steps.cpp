// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/expected_steps.hpp"

#include <algorithm>
#include <cmath>

#include "solver/results/plan.hpp"

namespace dmp::solver {

namespace {

/// Times nearer to each other than this share of an interval are one.
constexpr double rounding = 1e-9;

}  // namespace

double time_between_rows(const Scene& scene) {
    return *scene.output.measure_every > 0 ? *scene.output.measure_every : *scene.output.every / 4;
}

long expected_steps(const Scene& scene, double dt, double until) {
    const double frames = scene.output.every;
    const double rows = time_between_rows(scene);
    const double interval = std::min(frames, rows);
    const auto steps_in = [&](double length) { return std::max(1.0, std::ceil(length / dt * (1 - 1e-12))); };
    // Of so many intervals those that a time of the other kind divides do not count.
    constexpr double most_intervals = 1e6;
    if (!(until / interval <= most_intervals)) return steps_of(until / interval * steps_in(interval), 1);

    double steps = 0, time = 0;
    for (double frame = 1, row = 1; time < until * (1 - rounding);) {
        const double next = std::min({frame * frames, row * rows, until});
        if (next - time > rounding * interval) steps += steps_in(next - time);
        time = next;
        if (frame * frames <= next + rounding * interval) ++frame;
        if (row * rows <= next + rounding * interval) ++row;
    }
    return steps_of(steps, 1);
}

double expected_frames(const Scene& scene, double until) {
    const double due = std::floor(until / scene.output.every * (1 + 1e-12));
    return 1 + due + (until - due * scene.output.every > rounding * until ? 1 : 0);
}

}  // namespace dmp::solver
