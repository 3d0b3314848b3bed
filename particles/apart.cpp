// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/apart.hpp"

#include <string>

#include "base/errors.hpp"
#include "base/length_text.hpp"
#include "particles/set_grid.hpp"

namespace dmp::particles {

namespace {

std::string called(const ParticleSet& set, std::size_t i) {
    return std::to_string(i) + " of '" + set.parts[static_cast<std::size_t>(set.part[i])].name + "'";
}

}  // namespace

void check_apart(const ParticleSet& set) {
    const SetGrid grid(set, nearest_apart * set.spacing);
    for (std::size_t i = 0; i < set.size(); ++i)
        grid.for_each_near(i, [&](std::size_t j, const Vec& /*offset*/) {
            if (j == i) return;
            throw InputError("particles " + called(set, i) + " and " + called(set, j) + " lie on each other at " +
                                 position_text(set.position[i], set.dimension),
                             "Check the geometry for parts that overlap or lines drawn twice near there, or choose "
                             "another particles.spacing.");
        });
}

}  // namespace dmp::particles
