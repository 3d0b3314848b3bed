// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Shells and solids of springs in 3-D, alone and several in one set.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "mesher/shell_lattice.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/lattice_solids.hpp"

namespace dmp::tests::lattice_solids {

struct Surface {
    std::vector<Vec> points;
    std::vector<std::array<int, 3>> triangles;
};

/// A hexagon of equilateral triangles, `rings` edges of length a from its middle to a corner.
inline Surface hexagon(int rings, double edge, double perturbed = 0) {
    Surface surface;
    std::map<std::pair<int, int>, int> number;
    const auto inside = [&](int i, int j) {
        return std::abs(i) <= rings && std::abs(j) <= rings && std::abs(i + j) <= rings;
    };
    for (int j = -rings; j <= rings; ++j)
        for (int i = -rings; i <= rings; ++i) {
            if (!inside(i, j)) continue;
            number[{i, j}] = static_cast<int>(surface.points.size());
            const bool border = !inside(i + 1, j) || !inside(i, j + 1) || !inside(i - 1, j + 1) || !inside(i - 1, j) ||
                                !inside(i, j - 1) || !inside(i + 1, j - 1);
            const double off = border ? 0 : perturbed;
            surface.points.emplace_back(edge * (i + 0.5 * j + off * std::sin(7.0 * i + 3.0 * j)),
                                        edge * (std::sqrt(0.75) * j + off * std::sin(5.0 * i - 11.0 * j)), 0);
        }
    for (int j = -rings; j <= rings; ++j)
        for (int i = -rings; i <= rings; ++i) {
            const auto add = [&](std::pair<int, int> a, std::pair<int, int> b, std::pair<int, int> c) {
                if (number.contains(a) && number.contains(b) && number.contains(c))
                    surface.triangles.push_back({number[a], number[b], number[c]});
            };
            add({i, j}, {i + 1, j}, {i, j + 1});
            add({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
        }
    return surface;
}

inline ParticleSet hexagonal_shell(int rings, const ShellConstants& constants) {
    const Surface surface = hexagon(rings, constants.edge);
    return set_of(shell_lattice(surface.points, surface.triangles, constants));
}

/// Adds the free nodes of another set, moved, and their springs, as nodes of this part and body.
inline void append(ParticleSet& set, const ParticleSet& other, const Vec& shift, int part, int body) {
    const int first = static_cast<int>(set.size());
    for (std::size_t n = 0; n < other.size(); ++n) {
        set.position.emplace_back(other.position[n] + shift);
        set.volume.push_back(other.volume[n]);
        set.mass.push_back(other.mass[n]);
        set.part.push_back(part);
        set.body.push_back(body);
        set.fixed.push_back(0);
        set.seated.push_back(0);
        set.wall_normal.emplace_back(Vec::Zero());
        set.wall_distance.push_back(0);
    }
    for (Bond bond : other.bonds) {
        for (int* node : {&bond.a, &bond.b}) *node += first;
        set.bonds.push_back(bond);
    }
    for (Hinge hinge : other.hinges) {
        for (int* node : {&hinge.a, &hinge.centre, &hinge.b}) *node += first;
        set.hinges.push_back(hinge);
    }
    for (Dihedral four : other.dihedrals) {
        for (int* node : {&four.a, &four.b, &four.c, &four.d}) *node += first;
        set.dihedrals.push_back(four);
    }
}

}  // namespace dmp::tests::lattice_solids
