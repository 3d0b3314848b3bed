// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/sound_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/number_text.hpp"
#include "solver/run/column_pressure.hpp"

namespace dmp::solver {

namespace {

/// mu U / l of the most viscous fluid. 0 with the plain scheme, whose answer depends on the speed of sound, and with
/// implicit viscosity, whose long steps it would cut.
double viscous_pressure(const Scene& scene) {
    double viscosity = 0;
    if (*scene.numerics.scheme == FluidScheme::plain) return 0;
    if (*scene.numerics.viscosity_stepping == ViscosityStepping::implicitly) return 0;
    for (const Part* part : scene.parts_of(PartKind::fluid)) viscosity = std::max(viscosity, part->viscosity.value);
    return viscosity * scene.flow.largest_speed / (4 * scene.particles.spacing);
}

/// A pressure, and the speed of sound at which it changes the density by Ma^2.
SoundSpeed by_pressure(const Scene& scene, double pressure, double density, SoundSpeed::Origin origin) {
    return {.value = std::sqrt(pressure / density) / *scene.numerics.mach_number,
            .largest_pressure = pressure,
            .origin = origin};
}

const SoundSpeed& faster(const SoundSpeed& a, const SoundSpeed& b) { return b.value > a.value ? b : a; }

/// By the pressures of column_pressures, each by its fluid's density; 0 without any.
SoundSpeed by_columns(const Scene& scene, const ParticleSet& set) {
    SoundSpeed fastest{.value = 0, .origin = SoundSpeed::Origin::column_pressure};
    const std::vector<double> columns = column_pressures(scene, set);
    for (std::size_t part = 0; part < columns.size(); ++part) {
        if (columns[part] == 0) continue;
        const double density = scene.part_of_particles(set.parts[part].name).density;
        fastest = faster(fastest, by_pressure(scene, columns[part], density, SoundSpeed::Origin::column_pressure));
    }
    return fastest;
}

/// By the pressure that is given, or by those that can be estimated.
SoundSpeed by_expected_pressure(const Scene& scene, const ParticleSet& set) {
    const double lightest = lightest_density(scene);
    if (*scene.flow.largest_pressure > 0)
        return by_pressure(scene, scene.flow.largest_pressure, lightest, SoundSpeed::Origin::given_pressure);
    return faster(by_pressure(scene, viscous_pressure(scene), lightest, SoundSpeed::Origin::viscous_pressure),
                  by_columns(scene, set));
}

}  // namespace

double lightest_density(const Scene& scene) {
    double lightest = std::numeric_limits<double>::infinity();
    for (const Part* part : scene.parts_of(PartKind::fluid)) lightest = std::min(lightest, part->density.value);
    return lightest;
}

SoundSpeed choose_sound_speed(const Scene& scene, const ParticleSet& set) {
    if (*scene.numerics.sound_speed > 0) return {.value = scene.numerics.sound_speed};
    const SoundSpeed by_speed{.value = scene.flow.largest_speed / *scene.numerics.mach_number,
                              .origin = SoundSpeed::Origin::largest_speed};
    if (scene.parts_of(PartKind::fluid).empty()) return by_speed;
    return faster(by_speed, by_expected_pressure(scene, set));
}

std::vector<Warning> sound_speed_warnings(const Scene& scene, const ParticleSet& set, const SoundSpeed& chosen) {
    // Planned is Ma^2; the last digits of a value that follows this advice may be rounded.
    const double most_of_density = 1.01 * std::max(0.05, std::pow(*scene.numerics.mach_number, 2));
    const bool by_hand = chosen.origin == SoundSpeed::Origin::scene;
    if (!by_hand && *scene.flow.largest_pressure == 0) return {};
    const SoundSpeed needed = by_columns(scene, set);
    const double of_density = std::pow(*scene.numerics.mach_number * needed.value / chosen.value, 2);
    if (!(of_density > most_of_density)) return {};
    const std::string pressure = number_text(needed.largest_pressure, 3) + " Pa";
    const std::string problem = "is too low: the pressure by the body forces over the fluid's extent, " + pressure +
                                ", changes the density by " + number_text(100 * of_density, 3) + " %";
    if (by_hand)
        return {{"numerics.sound_speed", scene.numerics.sound_speed.location, problem,
                 "give \"" + number_text(needed.value, 3) + " m/s\" or more, or leave it out"}};
    return {{"flow.largest_pressure", scene.flow.largest_pressure.location, problem,
             "give \"" + pressure + "\" or more, or leave it out"}};
}

Scene with_sound_speed(Scene scene, const SoundSpeed& chosen) {
    if (chosen.is_from_pressure()) scene.numerics.sound_speed = Value<double>(chosen.value);
    return scene;
}

}  // namespace dmp::solver
