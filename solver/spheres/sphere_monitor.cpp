// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_monitor.hpp"

#include <cmath>
#include <sstream>

namespace dmp::solver {

namespace {

std::string describe(const SphereStep& step, const ParticleSpace& space, std::int32_t row) {
    const SphereMotion& sphere = step.rows().motion()[row];
    const ParticleTag& tag = step.group().tags()[row];
    std::ostringstream text;
    text << "sphere " << tag.id << " of '" << space.parts[tag.part].name << "' at (" << sphere.position.c[0] << " m, "
         << sphere.position.c[1] << " m, " << sphere.position.c[2] << " m), speed "
         << std::hypot(sphere.velocity.c[0], sphere.velocity.c[1], sphere.velocity.c[2]) << " m/s";
    return text.str();
}

}  // namespace

LargestOverlap largest_overlap(const SphereStep& step) {
    LargestOverlap largest;
    const ContactList& list = step.neighbours().list();
    const auto motion = step.rows().motion();
    const auto owned = static_cast<std::int32_t>(step.rows().owned());
    list.for_each([&](std::size_t k, std::int16_t) {
        const std::int32_t i = list.low()[k], j = list.high()[k];
        const double *a = motion[i].position.c, *b = motion[j].position.c;
        const double overlap = a[3] + b[3] - std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        if (overlap <= 0) return;
        if (i < owned) ++largest.touching;
        const double ratio = overlap / std::min(a[3], b[3]);
        if (ratio > largest.ratio) {
            largest.ratio = ratio;
            largest.row = a[3] < b[3] ? i : j;
        }
    });
    if (const SphereWalls::Overlap wall = step.walls().largest_overlap(step.rows()); wall.ratio > largest.ratio) {
        largest.ratio = wall.ratio;
        largest.row = wall.row;
        largest.at_wall = true;
    }
    return largest;
}

std::string trouble_with_spheres(const SphereStep& step, const ParticleSpace& space) {
    for (std::size_t i = 0; i < step.rows().owned(); ++i) {
        const SphereMotion& sphere = step.rows().motion()[i];
        double sum = 0;
        for (int c = 0; c < 3; ++c) sum += sphere.position.c[c] + sphere.velocity.c[c] + sphere.spin.c[c];
        if (!std::isfinite(sum))
            return describe(step, space, static_cast<std::int32_t>(i)) +
                   ": not finite\nlikely cause: numerics.steps_per_contact is too small, or contact_step too large";
    }
    const LargestOverlap largest = largest_overlap(step);
    if (largest.ratio <= most_overlap) return {};
    std::ostringstream text;
    text << describe(step, space, largest.row)
         << (largest.ratio >= 1 && largest.at_wall ? " has gone through a wall: " : ": ") << "it overlaps with "
         << (largest.at_wall ? "a wall" : "another sphere") << " by " << largest.ratio << " of its radius, more than "
         << most_overlap
         << "\nlikely cause: youngs_modulus is too small for how fast or how loaded the spheres are: by Hertz' law an "
            "impact of twice the speed needs four times the modulus for the same overlap";
    return text.str();
}

}  // namespace dmp::solver
