// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/node_mass.hpp"

#include <algorithm>

namespace dmp::solver {

std::vector<double> node_masses(const Scene& scene, const ParticleSet& set, double liquid_density) {
    std::vector<double> density;  // of the material by part
    for (const auto& [name, kind] : set.parts) {
        density.push_back(liquid_density);
        if (kind != PartKind::elastic) continue;
        const Part& part = scene.part_of_particles(name);
        // A strip is taken to be as thick as its rows of nodes: two spacings, or its thickness where that is more.
        const double of_rows = part.mass_per_length / std::max(2 * set.spacing, *part.thickness);
        if (part.density.given())
            density.back() = part.density;
        else if (of_rows > liquid_density)
            density.back() = of_rows;
    }
    std::vector<double> mass = set.mass;
    if (liquid_density == 0) return mass;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::elastic) continue;
        const double beside = set.volume[i] - set.mass[i] / density[set.part[i]];
        const Part& part = scene.part_of_particles(set.parts[set.part[i]].name);
        if (beside >= 0)
            mass[i] += liquid_density * beside;
        else if (part.density.given() && !part.thickness.given())  // a solid
            mass[i] += std::min(liquid_density, density[set.part[i]]) * beside;
    }
    return mass;
}

}  // namespace dmp::solver
