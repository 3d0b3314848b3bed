// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/sound_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dmp::solver {

namespace {

double largest_acceleration(const Scene& scene, int axis) {
    const Expression& formula = scene.flow.acceleration[axis];
    if (formula.depends_on_position()) return 0;
    double largest = 0;
    for (int k = 0; k <= 64; ++k) largest = std::max(largest, std::abs(formula(scene.run.duration * k / 64)));
    return largest;
}

double extent_of_fluid(const ParticleSet& set, int axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        low = std::min(low, set.position[i][axis]);
        high = std::max(high, set.position[i][axis]);
    }
    return high > low ? high - low + set.spacing : 0;
}

double column_pressure(const Scene& scene, const ParticleSet& set, double density) {
    double pressure = 0;
    for (int axis = 0; axis < set.dimension; ++axis) {
        if (set.periodic[axis]) continue;
        const double acceleration = largest_acceleration(scene, axis);
        if (acceleration > 0) pressure += density * acceleration * extent_of_fluid(set, axis);
    }
    return pressure;
}

}  // namespace

SoundSpeed choose_sound_speed(const Scene& scene, const ParticleSet& set) {
    SoundSpeed chosen;
    if (*scene.numerics.sound_speed > 0) {
        chosen.value = scene.numerics.sound_speed;
        return chosen;
    }
    double heaviest = 0, lightest = std::numeric_limits<double>::infinity();
    for (const Part* part : scene.parts_of(PartKind::fluid)) {
        heaviest = std::max(heaviest, part->density.value);
        lightest = std::min(lightest, part->density.value);
    }
    const double mach = scene.numerics.mach_number;
    chosen.value = scene.flow.largest_speed / mach;
    if (heaviest == 0) return chosen;
    chosen.pressure_is_estimated = *scene.flow.largest_pressure == 0;
    chosen.largest_pressure =
        chosen.pressure_is_estimated ? column_pressure(scene, set, heaviest) : scene.flow.largest_pressure.value;
    const double by_pressure = std::sqrt(chosen.largest_pressure / lightest) / mach;
    chosen.pressure_rules = by_pressure > chosen.value;
    chosen.value = std::max(chosen.value, by_pressure);
    return chosen;
}

Scene with_sound_speed(Scene scene, const SoundSpeed& chosen) {
    if (chosen.pressure_rules) scene.numerics.sound_speed = Value<double>(chosen.value);
    return scene;
}

}  // namespace dmp::solver
