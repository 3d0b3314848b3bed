// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/drive_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
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
    std::vector<double> rates;  // but for times at which it is constant, as between pulses
    for (int k = 0; k < samples; ++k) {
        const double t = sample_time(k, duration);
        const double value = formula(t, x[0], x[1], x[2]), next = formula(t + apart, x[0], x[1], x[2]);
        if (!std::isfinite(value) || !std::isfinite(next)) continue;  // StabilityMonitor says so when it comes to it
        low = std::min(low, value);
        high = std::max(high, value);
        const double rate = std::abs(next - value) / apart;
        if (rate > 0) rates.push_back(rate);
    }
    if (rates.size() < samples / 20) return infinity;  // jumps
    const auto middle = rates.begin() + static_cast<std::ptrdiff_t>(rates.size() / 2);
    std::ranges::nth_element(rates, middle);
    return *middle > 1e-6 * (high - low) / duration ? (high - low) / *middle : infinity;
}

/// Where one of the part's particles is; without any, of any part.
Vec place_of(const ParticleSet& set, const std::string& part) {
    const int number = set.part_named(part);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == number) return set.position[i];
    return set.size() > 0 ? set.position.front() : Vec::Zero();
}

}  // namespace

double drive_time(const Scene& scene, const ParticleSet& set) {
    double shortest = infinity;
    const auto look_at = [&](const auto& formulas, const std::string& part) {
        const Vec place = place_of(set, part);
        for (const Expression& formula : formulas)
            shortest = std::min(shortest, time_of(formula, scene.run.duration, place));
    };
    for (const PartKind moved : {PartKind::fluid, PartKind::elastic, PartKind::spheres})
        for (const Part* part : scene.parts_of(moved)) look_at(scene.flow.acceleration, part->name);
    for (const Part* fluid : scene.parts_of(PartKind::fluid)) look_at(*scene.flow.pressure_gradient, fluid->name);
    for (const Part* wall : scene.parts_of(PartKind::rigid)) {
        look_at(*wall->velocity, wall->name);
        look_at(*wall->surface_velocity, wall->name);
        look_at(std::array{*wall->spin}, wall->name);
    }
    for (const ForceOnPart& force : scene.forces) look_at(*force.force, force.part);
    return shortest;
}

}  // namespace dmp::solver
