// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/displacement_measure.hpp"

#include <limits>

#include "base/errors.hpp"

namespace dmp::solver {

DisplacementMeasure::DisplacementMeasure(const Measure& measure, const ParticleSet& set) {
    const int part = set.part_named(*measure.part);
    int nearest = -1;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.part[i] != part) continue;
        const int id = static_cast<int>(i);
        if (!measure.point.given()) {
            particles_.insert(id);
            continue;
        }
        const double away = nearest_image(set.position[i] - measure.point.value, set).norm();
        if (away < distance) {
            distance = away;
            nearest = id;
        }
    }
    if (!measure.point.given()) return;
    // Particles of a thin strip stand half a spacing beside the curve on which the point may lie.
    if (distance > 1.5 * set.spacing)
        throw InputError(measure.point.location,
                         "the point of measure '" + *measure.name + "' is not in '" + *measure.part + "'",
                         "move it into the solid: no particle is within 1.5 spacings of it");
    particles_.insert(nearest);
}

Vec DisplacementMeasure::mean(const SpringBodies& springs) const {
    Vec moment = Vec::Zero();
    double mass = 0;
    for (const auto& body : springs.bodies())
        for (std::size_t node = 0; node < body->nodes(); ++node) {
            if (!particles_.contains(body->ids()[node])) continue;
            moment += body->mass(node) * body->displacement(node);
            mass += body->mass(node);
        }
    return moment / mass;
}

}  // namespace dmp::solver
