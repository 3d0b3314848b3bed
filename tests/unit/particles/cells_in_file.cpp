// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/cells_in_file.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "particles/particle_file.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::cells_in_file_tests {
namespace {

/// Two cells side by side with a fluid particle, and what each number should be.
ParticleSet two_cells() {
    ParticleSet set;
    set.dimension = 2;
    set.spacing = 1;
    set.box = {Vec(0, 0, 0), Vec(3, 1, 0)};
    set.parts = {{"beam", PartKind::elastic}, {"water", PartKind::fluid}};
    set.position = {Vec(0.6, 0.5, 0), Vec(1.5, 0.4, 0), Vec(2.5, 0.5, 0)};
    set.volume = {0.8, 0.9, 1};
    set.mass = {800, 900, 1000};
    set.part = {0, 0, 1};
    set.body = {0, 0, -1};
    set.fixed = {0, 0, 0};
    set.seated = {0, 0, 0};
    set.wall_normal.assign(3, Vec::Zero());
    set.wall_distance.assign(3, 0);
    for (const double y : {0.0, 1.0})
        for (const double x : {0.0, 1.0, 2.0}) set.cell_nodes.push_back({Vec(x, y, 0), x == 0, {false, y == 1, false}});
    set.cells.push_back({0, {0, 1, 3, 4}, Vec(1, 1, 0), Vec(0.1, 0, 0), Vec(0.05, 0.08, 0)});
    set.cells.push_back({1, {1, 2, 4, 5}, Vec(1, 1, 0), Vec(0, -0.1, 0), Vec(0.07, 0.06, 0)});
    set.periodic[0] = true;
    set.cells[1].periods = SolidCell::period_bit(1, 0) | SolidCell::period_bit(3, 0);
    return set;
}

TEST(CellsInFile, are_read_as_they_were_written) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "particles.h5";
    const ParticleSet written = two_cells();
    write_particles(file, written);
    const ParticleSet read = read_particles(file);
    ASSERT_EQ(read.cell_nodes.size(), written.cell_nodes.size());
    for (std::size_t n = 0; n < read.cell_nodes.size(); ++n) {
        EXPECT_EQ(read.cell_nodes[n].position, written.cell_nodes[n].position);
        EXPECT_EQ(read.cell_nodes[n].fixed, written.cell_nodes[n].fixed);
        EXPECT_EQ(read.cell_nodes[n].on_plane, written.cell_nodes[n].on_plane);
    }
    ASSERT_EQ(read.cells.size(), written.cells.size());
    for (std::size_t n = 0; n < read.cells.size(); ++n) {
        EXPECT_EQ(read.cells[n].particle, written.cells[n].particle);
        EXPECT_EQ(read.cells[n].node, written.cells[n].node);
        EXPECT_EQ(read.cells[n].periods, written.cells[n].periods);
        EXPECT_EQ(read.cells[n].size, written.cells[n].size);
        EXPECT_EQ(read.cells[n].centroid, written.cells[n].centroid);
        EXPECT_EQ(read.cells[n].moment, written.cells[n].moment);
    }
}

TEST(CellsInFile, that_nobody_can_use_are_named) {
    EXPECT_EQ(problem_with_cells(two_cells()), "");
    const std::vector<std::pair<std::string, std::function<void(ParticleSet&)>>> wrongs{
        {"node 3 of cells is not finite", [](auto& set) { set.cell_nodes[3].position[0] = NAN; }},
        {"cell 1: its particle is not there", [](auto& set) { set.cells[1].particle = 3; }},
        {"cell 0: its particle is not there", [](auto& set) { set.cells[0].particle = -1; }},
        {"cell 1: its particle is another cell's", [](auto& set) { set.cells[1].particle = 0; }},
        {"cell 1: its particle is of no elastic solid", [](auto& set) { set.cells[1].particle = 2; }},
        {"cell 0: its particle is of no elastic solid", [](auto& set) { set.body[0] = -1; }},
        {"cell 0: its volume or mass is not more than 0", [](auto& set) { set.mass[0] = 0; }},
        {"cell 1: its size is not more than 0", [](auto& set) { set.cells[1].size[1] = 0; }},
        {"cell 1: its size is not more than 0", [](auto& set) { set.cells[1].size[0] = INFINITY; }},
        {"cell 0: its centroid is outside", [](auto& set) { set.cells[0].centroid[0] = 0.6; }},
        {"cell 0: a moment is less than 0", [](auto& set) { set.cells[0].moment[1] = -1e-3; }},
        {"cell 1: a corner is at a node that is not there", [](auto& set) { set.cells[1].node[2] = 6; }},
        {"cell 1: two corners are one node", [](auto& set) { set.cells[1].node[2] = 1; }},
        {"cell 1: a corner is a period away along an axis that has none", [](auto& set) { set.periodic[0] = false; }},
        {"cell 0: a corner is a period away along an axis that has none",
         [](auto& set) { set.cells[0].periods = SolidCell::period_bit(5, 0); }},
        {"cell 1: a node is another body's, too", [](auto& set) { set.body[1] = 1; }},
        {"particle 1 is in a body of cells, and is none", [](auto& set) { set.cells.pop_back(); }},
        {"bond 0 ends at a cell, which has no bonds", [](auto& set) {
             set.bonds.push_back({2, 1, 1, 1});
         }}};
    for (const auto& [says, change] : wrongs) {
        ParticleSet set = two_cells();
        change(set);
        EXPECT_EQ(problem_with_cells(set), says);
    }
}

}  // namespace
}  // namespace dmp::tests::cells_in_file_tests
