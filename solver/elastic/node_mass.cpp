// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/node_mass.hpp"

#include <algorithm>

namespace dmp::solver {

std::vector<double> node_masses(const Scene& scene, const ParticleSet& set, double liquid_density) {
    std::vector<double> density;  // of the material by part, as far as it is known
    for (const auto& [name, kind] : set.parts) {
        const bool known = kind == PartKind::elastic && scene.part_of_particles(name).density.given();
        density.push_back(known ? scene.part_of_particles(name).density.value : liquid_density);
    }
    std::vector<double> mass = set.mass;
    if (liquid_density == 0) return mass;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::elastic)
            mass[i] += liquid_density * std::max(0.0, set.volume[i] - set.mass[i] / density[set.part[i]]);
    return mass;
}

}  // namespace dmp::solver
