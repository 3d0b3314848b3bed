// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/sound_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

/// By the pressure that is given, or by those that can be estimated.
SoundSpeed by_expected_pressure(const Scene& scene, const ParticleSet& set) {
    const double lightest = lightest_density(scene);
    if (*scene.flow.largest_pressure > 0)
        return by_pressure(scene, scene.flow.largest_pressure, lightest, SoundSpeed::Origin::given_pressure);
    SoundSpeed fastest = by_pressure(scene, viscous_pressure(scene), lightest, SoundSpeed::Origin::viscous_pressure);
    const std::vector<double> columns = column_pressures(scene, set);
    for (std::size_t part = 0; part < columns.size(); ++part) {
        if (columns[part] == 0) continue;
        const double density = scene.part_of_particles(set.parts[part].name).density;
        fastest = faster(fastest, by_pressure(scene, columns[part], density, SoundSpeed::Origin::column_pressure));
    }
    return fastest;
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

Scene with_sound_speed(Scene scene, const SoundSpeed& chosen) {
    if (chosen.is_from_pressure()) scene.numerics.sound_speed = Value<double>(chosen.value);
    return scene;
}

}  // namespace dmp::solver
