// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/drive_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace dmp::solver {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Times at which no period repeats.
constexpr int samples = 997;
double sample_time(int k, double duration) { return duration * std::fmod(k * (std::numbers::phi - 1), 1.0); }

double time_of(const Expression& formula, double duration, const Vec& x) {
    if (!formula.depends_on_time()) return infinity;
    // Far above what rounding leaves of times, far below any step.
    const double apart = 1e-9 * duration;
    double low = infinity, high = -infinity;
    std::vector<double> rates;
    for (int k = 0; k < samples; ++k) {
        const double t = sample_time(k, duration);
        const double value = formula(t, x[0], x[1], x[2]), next = formula(t + apart, x[0], x[1], x[2]);
        low = std::min(low, value);
        high = std::max(high, value);
        rates.push_back(std::abs(next - value) / apart);
    }
    std::ranges::nth_element(rates, rates.begin() + samples / 2);
    const double rate = rates[samples / 2];
    return rate > 1e-6 * (high - low) / duration ? (high - low) / rate : infinity;
}

Vec place_of_fluid(const ParticleSet& set) {
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::fluid) return set.position[i];
    return Vec::Zero();
}

}  // namespace

double drive_time(const Scene& scene, const ParticleSet& set) {
    const Vec place = place_of_fluid(set);
    double shortest = infinity;
    const auto look_at = [&](const Expression& formula) {
        shortest = std::min(shortest, time_of(formula, scene.run.duration, place));
    };
    for (const auto* formulas : {&scene.flow.acceleration, &scene.flow.pressure_gradient.value})
        std::ranges::for_each(*formulas, look_at);
    for (const Part* wall : scene.parts_of(PartKind::rigid)) {
        std::ranges::for_each(*wall->velocity, look_at);
        std::ranges::for_each(*wall->surface_velocity, look_at);
        look_at(*wall->spin);
    }
    for (const ForceOnPart& force : scene.forces) std::ranges::for_each(*force.force, look_at);
    return shortest;
}

}  // namespace dmp::solver
