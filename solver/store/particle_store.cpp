// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

ParticleStore::ParticleStore(const ParticleSet& set, const std::vector<double>& density, const Ranks& ranks)
    : quantum_(set),
      space_(with_whole_periods(set, quantum_)),
      groups_{ParticleGroup(PartKind::fluid, set.dimension), ParticleGroup(PartKind::rigid, set.dimension),
              ParticleGroup(PartKind::elastic, set.dimension)} {
    const auto rank = static_cast<std::size_t>(ranks.rank()), size = static_cast<std::size_t>(ranks.size());
    const std::size_t begin = set.size() * rank / size, end = set.size() * (rank + 1) / size;
    std::array<std::size_t, 3> count{};
    for (std::size_t i = begin; i < end; ++i) ++count[static_cast<std::size_t>(set.kind(i))];
    for (ParticleGroup& group : groups_) {
        group.declare({Field::position, Field::velocity, Field::mass, Field::volume, Field::force});
        group.resize(count[static_cast<std::size_t>(group.kind())], 0);
    }
    std::array<std::size_t, 3> next{};
    for (std::size_t i = begin; i < end; ++i) {
        ParticleGroup& group = of(set.kind(i));
        const std::size_t k = next[static_cast<std::size_t>(group.kind())]++;
        group.tags()[k] = {static_cast<std::int64_t>(i), set.body[i], static_cast<std::uint16_t>(set.part[i])};
        for (int axis = 0; axis < dimension(); ++axis)
            group.data(Field::position, axis)[k] = quantum_.round(set.position[i][axis]);
        group.data(Field::mass)[k] = density[set.part[i]] * set.volume[i];
        group.data(Field::volume)[k] = set.volume[i];
    }
}

std::size_t ParticleStore::owned() const {
    std::size_t count = 0;
    for (const ParticleGroup& group : groups_) count += group.owned();
    return count;
}

std::size_t ParticleStore::bytes() const {
    std::size_t bytes = 0;
    for (const ParticleGroup& group : groups_) bytes += group.bytes();
    return bytes;
}

}  // namespace dmp::solver
