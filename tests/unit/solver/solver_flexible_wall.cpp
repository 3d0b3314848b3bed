// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Fluid beside an elastic wall that bulges beyond the plane of the rigid wall that it begins at.
#include <array>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/walled_water.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_flexible_wall_tests {
namespace {

constexpr int columns = 20, rows = 6, wall_ends = 10, pocket = 3;  // cells

Vec middle(int column, int row) { return {(column + 0.5) * spacing, (row + 0.5) * spacing, 0}; }

/// Water over a wall that ends in the middle; to its right a pocket of water, `pocket` cells deep, in an elastic lining
/// of one row of particles, which may be left out.
WalledWater water_with_a_pocket(bool lined) {
    WalledWater made(columns, rows, {"wall"},
                     [](int column, int row) { return row < 0 && column >= wall_ends && column < columns ? 0 : 1; });
    Part lining;
    lining.name = std::string("lining");
    lining.kind = PartKind::elastic;
    made.scene.parts.push_back(lining);
    made.particles.parts.push_back({"lining", PartKind::elastic});
    made.particles.box.low[1] = -(pocket + 1) * spacing;
    std::array<std::array<int, columns>, pocket + 1> node{};
    for (int row = -1; row >= -(pocket + 1); --row)
        for (int column = wall_ends; column < columns; ++column) {
            const bool is_water = row >= -pocket && column > wall_ends;
            int& number = node.at(static_cast<std::size_t>(-row - 1)).at(static_cast<std::size_t>(column));
            number = -1;
            if (is_water) made.add(0, middle(column, row), Vec::Zero(), 0);
            if (is_water || !lined) continue;
            number = static_cast<int>(made.particles.size());
            made.add(2, middle(column, row), Vec::Zero(), 0);
            made.particles.body.back() = 0;
            const int left = column > wall_ends
                                 ? node[static_cast<std::size_t>(-row - 1)][static_cast<std::size_t>(column - 1)]
                                 : -1;
            const int above =
                row < -1 ? node[static_cast<std::size_t>(-row - 2)][static_cast<std::size_t>(column)] : -1;
            for (const int other : {left, above})
                if (other >= 0) made.particles.bonds.push_back({other, number, spacing, 1e3});
        }
    made.scene.run.duration = 0.01;
    return made;
}

TEST(FlexibleWall, that_bulges_beyond_the_plane_of_a_rigid_one_keeps_its_fluid) {
    EXPECT_EQ(run_of(water_with_a_pocket(true)).lost, 0U);
    EXPECT_GT(run_of(water_with_a_pocket(false)).lost, 0U) << "it is behind the wall's plane";
}

}  // namespace
}  // namespace dmp::tests::solver_flexible_wall_tests
