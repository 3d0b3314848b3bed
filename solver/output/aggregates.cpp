// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/aggregates.hpp"

#include <algorithm>

#include "solver/parallel/exact_sum.hpp"

namespace dmp::solver {

Aggregate aggregate_of(const SpringBodies& springs, int origin) {
    const auto number = static_cast<std::size_t>(origin);
    Aggregate all;
    all.name = springs.names()[number];
    all.bonds_made = springs.tally()[number].made;
    all.bonds_broken = springs.tally()[number].broken;
    ExactSum mass;
    for (const auto& body : springs.bodies()) {
        std::int64_t own = 0;
        for (std::size_t node = 0; node < body->nodes(); ++node) {
            if (body->origin(node) != origin || body->of_wall(node)) continue;
            ++own;
            mass.add(body->mass(node));
        }
        all.particles += own;
        all.pieces += own > 0 ? 1 : 0;
        all.largest = std::max(all.largest, own);
    }
    all.mass = mass.value();
    return all;
}

std::vector<double> values_of(const Aggregate& aggregate) {
    return {static_cast<double>(aggregate.particles),  aggregate.mass,
            static_cast<double>(aggregate.pieces),     static_cast<double>(aggregate.largest),
            static_cast<double>(aggregate.bonds_made), static_cast<double>(aggregate.bonds_broken)};
}

}  // namespace dmp::solver
