// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/bond_report.hpp"

#include <numeric>

namespace dmp {

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
    std::vector<std::size_t> root(set.size());  // a node that it hangs together with; the first of a piece: itself
    std::iota(root.begin(), root.end(), 0U);
    const auto root_of = [&](int node) {
        auto k = static_cast<std::size_t>(node);
        while (root[k] != k) k = root[k] = root[root[k]];
        return k;
    };
    for (const Bond& bond : set.bonds) {
        const std::size_t a = root_of(bond.a), b = root_of(bond.b);
        root[std::max(a, b)] = std::min(a, b);
    }
    for (MeshReport::SpringLine& line : result.report.springs)
        for (std::size_t i = 0; i < set.size(); ++i) {
            if (set.parts[static_cast<std::size_t>(set.part[i])].name != line.part) continue;
            const auto count = static_cast<std::size_t>(bonds[i]);
            if (line.valence.size() <= count) line.valence.resize(count + 1);
            ++line.valence[count];
            line.pieces += root[i] == i ? 1 : 0;
        }
}

}  // namespace dmp
