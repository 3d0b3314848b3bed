// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// How many spheres of radius r hide the part `coverage` of the surface of one of radius R they sit on, rounded:
/// coverage = N r^2 / (4 (R + r)^2), their cross sections over the sphere through their centres.
int count_for_coverage(double coverage, double inner_radius, double radius);
double coverage_of(int count, double inner_radius, double radius);

/// `count` points at random on the sphere of radius `shell` about `centre`, no two of them nearer than 2 radius; the
/// same for the same seed. Spread evenly, moved at random by about half their distance, then pushed apart where they
/// are too near. Nothing where that finds no room, at coverages beyond about 0.8.
std::optional<std::vector<Vec>> pack_around(const Vec& centre, double shell, double radius, int count,
                                            std::uint64_t seed);

/// What spheres are put into.
struct Room {
    Box box;                        ///< the spheres lie in it as a whole
    std::vector<Vec> centres;       ///< of spheres that are there already
    std::vector<double> radii;      ///< of those
    std::vector<WallPlane> planes;  ///< that they may not cross
};

/// `count` centres of spheres at random in the room, none of which touches another or what is there; the same for the
/// same seed. Nothing where no room was found, at volume fractions beyond about 0.6.
std::optional<std::vector<Vec>> pack_room(const Room& room, double radius, int count, std::uint64_t seed);

}  // namespace dmp::mesher
