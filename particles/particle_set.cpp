// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_set.hpp"

#include <algorithm>

namespace dmp {

std::size_t ParticleSet::count(ParticleKind wanted) const {
    return static_cast<std::size_t>(std::count_if(
        part.begin(), part.end(), [&](int p) { return parts[static_cast<std::size_t>(p)].kind == wanted; }));
}

}  // namespace dmp
