// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_set.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::particles {

int ParticleSpace::part_named(const std::string& name) const {
    const auto found = std::ranges::find(parts, name, &PartInfo::name);
    return found == parts.end() ? -1 : static_cast<int>(found - parts.begin());
}

std::size_t ParticleSet::count(PartKind wanted) const {
    return static_cast<std::size_t>(std::count_if(
        part.begin(), part.end(), [&](int p) { return parts[static_cast<std::size_t>(p)].kind == wanted; }));
}

Vec nearest_image(Vec apart, const ParticleSpace& space) {
    for (int axis = 0; axis < space.dimension; ++axis) {
        if (!space.periodic[axis]) continue;
        const double period = space.box.high[axis] - space.box.low[axis];
        apart[axis] -= period * std::round(apart[axis] / period);
    }
    return apart;
}

}  // namespace dmp::particles
