// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "solver/neighbours/cluster_list.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/sweeps/vector.hpp"

namespace dmp::testing_solver {

/// A disordered crowd of all kinds of particles in a square of 20 x 20 spacings: fluid with a wall and two spring
/// bodies strewn among it, all shaken by a third of a spacing.
inline ParticleSet crowd(std::array<bool, 3> periodic, unsigned seed = 1) {
    constexpr int side = 20;
    constexpr double spacing = 0.1;
    ParticleSet set;
    set.spacing = spacing;
    set.box = {Vec::Zero(), Vec(side * spacing, side * spacing, 0)};
    set.periodic = periodic;
    set.parts = {{"water", ParticleKind::fluid}, {"wall", ParticleKind::rigid}, {"flags", ParticleKind::springs}};
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = (column + 0.5 + 0.33 * unit(random)) * spacing;
            const double y = (row + 0.5 + 0.33 * unit(random)) * spacing;
            const int pick = static_cast<int>(random() % 8);
            const int part = pick < 5 ? 0 : pick < 6 ? 1 : 2;
            set.position.emplace_back(x, y, 0);
            set.part.push_back(part);
            set.body.push_back(part == 2 ? pick - 6 : -1);
            set.volume.push_back(spacing * spacing * (1 + 0.1 * unit(random)));
            set.mass.push_back(1000 * set.volume.back());
            set.fixed.push_back(part == 1 ? 1 : 0);
            set.seated.push_back(0);
            const double angle = 3 * unit(random);
            set.wall_normal.push_back(part == 1 ? Vec(std::cos(angle), std::sin(angle), 0) : Vec(Vec::Zero()));
            set.wall_distance.push_back(part == 1 ? spacing * (1.5 + unit(random)) : 0);
        }
    return set;
}

/// Calls visit(i, j, x_i - x_j) for every ordered pair of owned particles, once for each periodic image of j that lies
/// within `reach`; a particle meets its own images but not itself. Slow and plain: the oracle of neighbour lists.
template <class Visit>
void for_all_pairs(const ParticleStore& particles, const ParticleSet& set, double reach, const Visit& visit) {
    const auto shifts = [&](int axis) { return set.periodic[axis] ? std::vector<int>{-1, 0, 1} : std::vector<int>{0}; };
    const Vec period = set.box.extent();
    const auto at = [&](std::size_t i, int axis) { return particles.data(Field::position, axis)[i]; };
    for (std::size_t i = 0; i < particles.owned(); ++i)
        for (std::size_t j = 0; j < particles.owned(); ++j)
            for (const int x_shift : shifts(0))
                for (const int y_shift : shifts(1)) {
                    if (i == j && x_shift == 0 && y_shift == 0) continue;
                    // The image's place is rounded as the store rounds it.
                    const Vector<double, 2> separation{
                        {at(i, 0) - (at(j, 0) + x_shift * period[0]), at(i, 1) - (at(j, 1) + y_shift * period[1])}};
                    if (dot(separation, separation) < reach * reach)
                        visit(static_cast<int>(i), static_cast<int>(j), separation);
                }
}

/// Two particles that the lists leave out: walls among themselves, and nodes of one spring body.
inline bool never_meet(const ParticleSet& set, int i, int j) {
    if (set.kind(i) != set.kind(j)) return false;
    return set.kind(i) == ParticleKind::rigid || (set.kind(i) == ParticleKind::springs && set.body[i] == set.body[j]);
}

}  // namespace dmp::testing_solver
