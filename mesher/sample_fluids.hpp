// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// The number of the fluid part (index into ParticleSet::parts) in whose room a place of the box lies; -1: none. Any
/// number of threads asks at once.
using FluidPartAt = std::function<int(const Vec& position)>;

/// particles.fill = "sampled": gives the fluid's particles, as many of each part as there are, places at random that
/// keep their distance (blue noise), without directions of a lattice. Of `candidates_per_particle` times as many
/// places, evenly distributed at random in the fluid's room, those with the most neighbours are eliminated one by one,
/// a place counting
///   SUM_j (1 - r_ij / R)^8,   r_ij < R = 2 r_max
/// over what is left, with r_max half the distance of neighbours in the densest packing (Yuksel, Comput. Graph. Forum
/// 34 (2015) 25). Walls and bodies count as neighbours and stay.
/// @param cell_volume what a particle stands for [m^2 x 1 m or m^3]
/// @return what was done, in words
std::string sample_fluids(ParticleSet& set, double cell_volume, std::uint64_t seed, const FluidPartAt& part_at,
                          int threads);

}  // namespace dmp::mesher
