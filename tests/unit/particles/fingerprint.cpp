// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/fingerprint.hpp"

#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::fingerprint_tests {
namespace {

ParticleSet two_particles() {
    ParticleSet set;
    set.spacing = 0.1;
    set.parts = {{"leaflet", PartKind::elastic}};
    set.position = {Vec(0, 0, 0), Vec(0.1, 0, 0)};
    set.volume = {0.01, 0.01};
    set.mass = {1, 1};
    set.part = {0, 0};
    set.body = {0, 0};
    set.fixed = {1, 0};
    set.seated = {0, 0};
    set.wall_normal = {Vec::Zero(), Vec::Zero()};
    set.wall_distance = {0, 0};
    set.bonds = {{0, 1, 0.1, 5, -1}};
    return set;
}

TEST(Fingerprint, DependsOnAllThatAGeometryGives) {
    const std::vector<std::function<void(ParticleSet&)>> changes{
        [](ParticleSet& set) { set.spacing = 0.2; },
        [](ParticleSet& set) { set.box.high[0] = 1; },
        [](ParticleSet& set) { set.periodic[1] = true; },
        [](ParticleSet& set) { set.mirrored[1][0] = true; },
        [](ParticleSet& set) { set.parts[0].name = "leaf"; },
        [](ParticleSet& set) { set.parts[0].kind = PartKind::rigid; },
        [](ParticleSet& set) { set.position[1][0] += 1e-17; },
        [](ParticleSet& set) { set.volume[1] = 0.011; },
        [](ParticleSet& set) { set.body[1] = 1; },
        [](ParticleSet& set) { set.fixed[1] = 1; },
        [](ParticleSet& set) { set.seated[1] = 1; },
        [](ParticleSet& set) { set.wall_normal[0][1] = 1; },
        [](ParticleSet& set) { set.wall_distance[0] = 1; },
        [](ParticleSet& set) {
            set.radius = {0.1, 0.1};
        },
        [](ParticleSet& set) { set.bonds[0].rest_length = 0.2; },
        [](ParticleSet& set) { set.bonds.clear(); },
        [](ParticleSet& set) {
            set.hinges = {{0, 1, 0, 1, 1}};
        },
        [](ParticleSet& set) {
            set.dihedrals = {{0, 1, 0, 1, 1, 1}};
        },
        [](ParticleSet& set) { set.cells = {{}}; },
        [](ParticleSet& set) {
            set.cells = {{.particle = 0, .node = {0, 1}}};
        },
        [](ParticleSet& set) { set.cells = {{.particle = 0, .moment = Vec(0, 1, 0)}}; },
        [](ParticleSet& set) {
            set.cells = {{}};
            set.cell_nodes = {{Vec(1, 2, 3), true}};
        },
        [](ParticleSet& set) {
            set.cells = {{}};
            set.cell_nodes = {{Vec(1, 2, 3), true, {true, false, false}}};
        },
        [](ParticleSet& set) {
            set.cells = {{}};
            set.cells[0].periods = 3;
        },
        [](ParticleSet& set) { set.wall_planes = {{}}; },
        [](ParticleSet& set) { set.wall_corners = {Vec::Zero()}; },
        [](ParticleSet& set) { set.wall_triangles = {{}}; },
        [](ParticleSet& set) { set.contact_pieces = {{}}; },
        [](ParticleSet& set) {
            set.contact_pieces = {{0, 0, 0, ContactPiece::none, 0.5}};
        },
        [](ParticleSet& set) {
            set.contact_pieces = {{0, 0, 0, 0, 0}};
        },
        [](ParticleSet& set) {
            set.contact_pieces = {{}};
            set.contact_points = {Vec::Zero()};
        }};
    std::set<std::string> seen{fingerprint(two_particles())};
    EXPECT_EQ(seen.begin()->size(), 16U);
    for (const auto& change : changes) {
        ParticleSet set = two_particles();
        change(set);
        EXPECT_TRUE(seen.insert(fingerprint(set)).second) << "change " << seen.size();
    }
}

TEST(Fingerprint, LeavesOutWhatAScenesValuesGive) {
    ParticleSet set = two_particles();
    set.mass[1] = 3;
    set.bonds[0].stiffness = 7;
    EXPECT_EQ(fingerprint(set), fingerprint(two_particles()));
}

TEST(Fingerprint, OfMoreThanABlockDependsOnTheFirstAndTheLast) {
    ParticleSet set;
    set.position.assign(10'000, Vec::Zero());
    const std::string before = fingerprint(set);
    set.position.front()[0] = 1;
    const std::string first = fingerprint(set);
    set.position.front()[0] = 0;
    set.position.back()[2] = 1;
    EXPECT_NE(first, before);
    EXPECT_NE(fingerprint(set), before);
    EXPECT_NE(fingerprint(set), first);
}

}  // namespace
}  // namespace dmp::tests::fingerprint_tests
