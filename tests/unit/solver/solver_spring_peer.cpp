// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/statics.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::solver_spring_peer_tests {
namespace {

namespace fs = std::filesystem;
using V3 = Vector<double, 3>;
using Body = SpringNetwork<3>;

/// What LAMMPS found (tests/peers/lammps_springs).
struct Reference {
    ParticleSet set;
    std::vector<V3> velocity, force, end;  ///< at the start, at the start, after the last step
    double bond_energy = 0, angle_energy = 0;
    int steps = 0;
    double dt = 0;
};

Reference read(const fs::path& file) {
    Reference reference;
    std::vector<Vec> position;
    std::vector<double> mass;
    std::vector<Bond> bonds;
    std::vector<Hinge> hinges;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream text(line);
        std::string kind;
        text >> kind;
        const auto vector = [&] {
            V3 v{};
            text >> v[0] >> v[1] >> v[2];
            return v;
        };
        if (kind == "step") text >> reference.steps >> reference.dt;
        if (kind == "energy") text >> reference.bond_energy >> reference.angle_energy;
        if (kind == "bond") {
            Bond bond;
            text >> bond.a >> bond.b >> bond.stiffness >> bond.rest_length;
            bonds.push_back(bond);
        }
        if (kind == "angle") {
            Hinge hinge;
            double degrees = 0;
            text >> hinge.a >> hinge.centre >> hinge.b >> hinge.stiffness >> degrees;
            hinge.rest_angle = degrees * std::numbers::pi / 180;
            hinges.push_back(hinge);
        }
        if (kind == "node") {
            mass.push_back(0);
            text >> mass.back();
            const V3 at = vector();
            position.emplace_back(at[0], at[1], at[2]);
            for (auto* values : {&reference.velocity, &reference.force, &reference.end}) values->push_back(vector());
        }
        EXPECT_FALSE(text.fail()) << line;
    }
    reference.set = set_of_nodes(3, position, mass);
    reference.set.bonds = bonds;
    reference.set.hinges = hinges;
    return reference;
}

void expect_what_the_peer_found(const Reference& peer) {
    ASSERT_EQ(peer.set.size(), 40U);
    ASSERT_GT(peer.set.bonds.size(), 45U);
    ASSERT_GT(peer.set.hinges.size(), 40U);
    ASSERT_EQ(peer.steps, 1000);
    const Part part = part_with(0);
    ParticleSet bonds = peer.set, hinges = peer.set;
    bonds.hinges.clear();
    hinges.bonds.clear();
    EXPECT_NEAR(Body(bonds, part, 0).energy() / peer.bond_energy, 1, 1e-9);
    EXPECT_NEAR(Body(hinges, part, 0).energy() / peer.angle_energy, 1, 1e-9);

    Body body(peer.set, part, 0);
    const auto force = body.forces(body.positions(), Body::Vectors(peer.set.size(), V3{}));
    for (std::size_t n = 0; n < force.size(); ++n) {
        const double size = std::sqrt(dot(peer.force[n], peer.force[n]));
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(force[n][axis], peer.force[n][axis], 1e-9 * size) << n;
    }

    // Velocity Verlet takes forces at its steps, drift-kick-drift in the middle of its own: the same leapfrog, when
    // ours begins half a step earlier, with the velocity of then.
    const double dt = peer.dt;
    Body::Vectors impulses(peer.set.size());
    for (std::size_t n = 0; n < impulses.size(); ++n) {
        const V3 velocity = peer.velocity[n] - (dt / 2 / peer.set.mass[n]) * peer.force[n];
        impulses[n] = peer.set.mass[n] * velocity;
        body.positions()[n] -= (dt / 2) * velocity;
    }
    body.kick_from_outside(impulses, 1);
    for (int step = 0; step < peer.steps; ++step) body.advance_subcycled(dt, 1);
    double farthest = 0;
    for (std::size_t n = 0; n < impulses.size(); ++n) {
        const V3 at = body.positions()[n] + (dt / 2) * body.velocities()[n];
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(at[axis], peer.end[n][axis], 1e-6) << "node " << n;
        farthest = std::max(farthest, std::abs(at[0] - peer.set.position[n][0]));
    }
    EXPECT_GT(farthest, 0.5);
}

TEST(SpringPeer, forces_energies_and_a_thousand_steps_are_those_lammps_found) {
    expect_what_the_peer_found(read(fs::path(DMP_SOURCE_DIR) / "tests/data/springs_lammps.txt"));
}

TEST(SpringPeer, lammps_on_this_machine_finds_the_same) {
    if (std::system("command -v lmp > /dev/null && command -v python3 > /dev/null") != 0)
        GTEST_SKIP() << "no lmp (Debian's package lammps) or no python3 on the path";
    const TemporaryFolder folder;
    const fs::path reference = folder.path() / "reference.txt";
    const std::string script = std::string(DMP_SOURCE_DIR) + "/tests/peers/lammps_springs/make_reference.py";
    ASSERT_EQ(std::system(("OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 python3 '" +
                           script + "' '" + reference.string() + "' '" + folder.path().string() + "'")
                              .c_str()),
              0);
    expect_what_the_peer_found(read(reference));
}

}  // namespace
}  // namespace dmp::tests::solver_spring_peer_tests
