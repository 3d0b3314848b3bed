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

/// mu U / l of the most viscous fluid. 0 with the plain scheme, whose answer depends on the speed of sound, and with
/// implicit viscosity, whose long steps it would cut.
double viscous_pressure(const Scene& scene) {
    double viscosity = 0;
    if (*scene.numerics.scheme == FluidScheme::plain) return 0;
    if (*scene.numerics.viscosity_stepping == ViscosityStepping::implicitly) return 0;
    for (const Part* part : scene.parts_of(PartKind::fluid)) viscosity = std::max(viscosity, part->viscosity.value);
    return viscosity * scene.flow.largest_speed / (4 * scene.particles.spacing);
}

SoundSpeed expected_pressure(const Scene& scene, const ParticleSet& set, double density) {
    if (*scene.flow.largest_pressure > 0)
        return {.largest_pressure = scene.flow.largest_pressure, .origin = SoundSpeed::Origin::given_pressure};
    const double column = column_pressure(scene, set, density), viscous = viscous_pressure(scene);
    if (viscous > column) return {.largest_pressure = viscous, .origin = SoundSpeed::Origin::viscous_pressure};
    return {.largest_pressure = column, .origin = SoundSpeed::Origin::column_pressure};
}

}  // namespace

SoundSpeed choose_sound_speed(const Scene& scene, const ParticleSet& set) {
    if (*scene.numerics.sound_speed > 0) return {.value = scene.numerics.sound_speed};
    double heaviest = 0, lightest = std::numeric_limits<double>::infinity();
    for (const Part* part : scene.parts_of(PartKind::fluid)) {
        heaviest = std::max(heaviest, part->density.value);
        lightest = std::min(lightest, part->density.value);
    }
    const double mach = scene.numerics.mach_number;
    const double by_speed = scene.flow.largest_speed / mach;
    if (heaviest == 0) return {.value = by_speed, .origin = SoundSpeed::Origin::largest_speed};
    SoundSpeed chosen = expected_pressure(scene, set, heaviest);
    chosen.value = std::sqrt(chosen.largest_pressure / lightest) / mach;
    if (by_speed >= chosen.value) {
        chosen.value = by_speed;
        chosen.origin = SoundSpeed::Origin::largest_speed;
    }
    return chosen;
}

Scene with_sound_speed(Scene scene, const SoundSpeed& chosen) {
    if (chosen.is_from_pressure()) scene.numerics.sound_speed = Value<double>(chosen.value);
    return scene;
}

}  // namespace dmp::solver
