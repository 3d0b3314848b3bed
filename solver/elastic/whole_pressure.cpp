// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/whole_pressure.hpp"

#include <algorithm>

namespace dmp::solver {

void fill_whole_pressure(const std::vector<bool>& dry_bodies, ParticleStore& particles) {
    ParticleGroup& solids = particles.of(PartKind::elastic);
    if (!solids.has(Field::whole_pressure)) return;
    for (std::size_t i = 0; i < solids.owned(); ++i) {
        const auto body = static_cast<std::size_t>(solids.tags()[i].body);
        solids.data(Field::whole_pressure)[i] = body < dry_bodies.size() && dry_bodies[body] ? 1 : 0;
    }
}

void spread_whole_pressure(ParticleStore& particles, std::size_t bodies, const Ranks& ranks) {
    ParticleGroup& solids = particles.of(PartKind::elastic);
    if (!solids.has(Field::whole_pressure)) return;
    double* whole = solids.data(Field::whole_pressure);
    std::vector<double> of_body(bodies);
    const auto body_of = [&](std::size_t i) { return static_cast<std::size_t>(solids.tags()[i].body); };
    for (std::size_t i = 0; i < solids.owned(); ++i) of_body[body_of(i)] = std::max(of_body[body_of(i)], whole[i]);
    ranks.largest(of_body);
    for (std::size_t i = 0; i < solids.owned(); ++i) whole[i] = of_body[body_of(i)];
}

}  // namespace dmp::solver
