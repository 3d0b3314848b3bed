// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesher/mesh.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// Keeps the particles that `keep` is not 0 for, in their order; of no bonds, which would change their numbers.
inline void keep_particles(ParticleSet& set, const std::vector<std::uint8_t>& keep) {
    const auto keep_flagged = [&](auto& values) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (keep[i] != 0) values[kept++] = values[i];
        values.resize(kept);
    };
    const auto keep_all = [&](auto&... values) { (keep_flagged(values), ...); };
    keep_all(set.position, set.volume, set.mass, set.part, set.body, set.fixed, set.seated, set.wall_normal,
             set.wall_distance);
}

/// Gives each particle of a fluid an equal share of the volume that the geometry asks for.
inline void share_volume(ParticleSet& set, int part, MeshReport::PartLine& line) {
    const double volume = line.target / static_cast<double>(line.particles);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.part[i] != part) continue;
        set.mass[i] *= volume / set.volume[i];
        set.volume[i] = volume;
    }
    line.reached = line.target;
}

}  // namespace dmp::mesher
