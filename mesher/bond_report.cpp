// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/bond_report.hpp"

#include "base/disjoint_sets.hpp"

namespace dmp::mesher {

std::vector<int> valence(const ParticleSet& set) {
    std::vector<int> bonds(set.size());
    for (const Bond& bond : set.bonds) {
        ++bonds[static_cast<std::size_t>(bond.a)];
        ++bonds[static_cast<std::size_t>(bond.b)];
    }
    return bonds;
}

void count_bonds(MeshResult& result) {
    if (result.report.springs.empty()) return;
    const ParticleSet& set = result.particles;
    const std::vector<int> bonds = valence(set);
    DisjointSets pieces(set.size());
    for (const Bond& bond : set.bonds) {
        const auto a = static_cast<std::size_t>(bond.a), b = static_cast<std::size_t>(bond.b);
        if (set.part[a] == set.part[b]) pieces.join(a, b);
    }
    for (MeshReport::SpringLine& line : result.report.springs)
        for (std::size_t i = 0; i < set.size(); ++i) {
            if (set.parts[static_cast<std::size_t>(set.part[i])].name != line.part) continue;
            const auto count = static_cast<std::size_t>(bonds[i]);
            if (line.valence.size() <= count) line.valence.resize(count + 1);
            ++line.valence[count];
            line.pieces += pieces.find(i) == i ? 1 : 0;
        }
}

}  // namespace dmp::mesher
