// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "solver/models/dem/contact_law.hpp"
#include "tests/unit/solver/lammps_spheres.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp {
namespace {

namespace fs = std::filesystem;
using V3 = Vector<double, 3>;
using Law = ContactLaw<ContactModel{TangentialHistory::plain, RollingFriction::none, Adhesion::none}>;

/// Every pair of spheres in turn; contacts keep their history while they last.
class AllPairs {
  public:
    explicit AllPairs(const LammpsSpheres& spheres) : spheres_(spheres), state(spheres.start) { find_forces(0); }

    /// Velocity Verlet: forces see the velocities of half a step ago, which moved the spheres here.
    void step(double dt) {
        kick(dt / 2);
        for (std::size_t i = 0; i < spheres_.size(); ++i) state.position[i] += dt * state.velocity[i];
        find_forces(dt);
        kick(dt / 2);
    }
    [[nodiscard]] std::size_t contacts() const { return histories_.size(); }

  private:
    const LammpsSpheres& spheres_;
    std::map<std::pair<std::size_t, std::size_t>, Law::History<double>> histories_;

  public:
    LammpsSpheres::State state;
    std::size_t sliding = 0;  ///< contacts at Coulomb's bound

  private:
    void kick(double dt) {
        for (std::size_t i = 0; i < spheres_.size(); ++i) {
            const double mass = spheres_.mass[i], radius = spheres_.radius[i];
            state.velocity[i] += (dt / mass) * state.force[i];
            state.spin[i] += (dt / (0.4 * mass * radius * radius)) * state.torque[i];
        }
    }
    void find_forces(double dt) {
        sliding = 0;
        for (auto* sums : {&state.force, &state.torque}) std::fill(sums->begin(), sums->end(), V3{});
        for (std::size_t i = 0; i < spheres_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) meet(i, j, dt);
    }
    [[nodiscard]] SpherePoint<double> sphere(std::size_t i) const {
        return {state.velocity[i], state.spin[i], spheres_.radius[i], spheres_.mass[i]};
    }
    void meet(std::size_t i, std::size_t j, double dt) {
        const V3 separation = state.position[i] - state.position[j];
        const double distance = std::sqrt(dot(separation, separation));
        if (distance >= spheres_.radius[i] + spheres_.radius[j]) {
            histories_.erase({i, j});
            return;
        }
        const auto contact = contact_of_spheres<Law>(sphere(i), sphere(j), separation, distance);
        const auto force = Law::law(contact, spheres_.pair, histories_[{i, j}], dt);
        state.force[i] += force.on_i(contact.normal);
        state.force[j] -= force.on_i(contact.normal);
        state.torque[i] += force.torque(spheres_.radius[i], contact.normal);
        state.torque[j] += force.torque(spheres_.radius[j], contact.normal);
        const double bound = spheres_.pair.friction * std::abs(force.normal);
        sliding += dot(force.tangential, force.tangential) > 0.999 * bound * bound ? 1 : 0;
    }
};

void expect_near(const std::vector<V3>& found, const std::vector<V3>& expected, double tolerance, const char* what) {
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(found[i][axis], expected[i][axis], tolerance) << what << " of sphere " << i;
}
double largest(const std::vector<V3>& values) {
    double most = 0;
    for (const V3& v : values) most = std::max(most, std::sqrt(dot(v, v)));
    return most;
}
void expect_near_each(const std::vector<V3>& found, const std::vector<V3>& expected, double tolerance) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double size = std::sqrt(dot(expected[i], expected[i]));
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(found[i][axis], expected[i][axis], tolerance * size) << "sphere " << i;
    }
}

void expect_what_the_peer_found(const LammpsSpheres& peer) {
    ASSERT_EQ(peer.size(), 200U);
    ASSERT_EQ(peer.steps, 1000);
    AllPairs spheres(peer);
    EXPECT_GT(spheres.contacts(), 250U);
    expect_near_each(spheres.state.force, peer.start.force, 1e-9);
    expect_near_each(spheres.state.torque, peer.start.torque, 1e-9);

    std::size_t slid = 0, held = 0;
    for (int step = 0; step < peer.steps; ++step) {
        spheres.step(peer.dt);
        slid += spheres.sliding;
        held += spheres.contacts() - spheres.sliding;
    }
    expect_near(spheres.state.position, peer.end.position, 1e-6 * 1e-3, "position");
    expect_near(spheres.state.velocity, peer.end.velocity, 1e-6 * largest(peer.end.velocity), "velocity");
    expect_near(spheres.state.spin, peer.end.spin, 1e-6 * largest(peer.end.spin), "spin");
    expect_near(spheres.state.force, peer.end.force, 1e-6 * largest(peer.end.force), "force");
    expect_near(spheres.state.torque, peer.end.torque, 1e-6 * largest(peer.end.torque), "torque");
    EXPECT_GT(spheres.contacts(), 100U);
    EXPECT_GT(slid, 10000U);
    EXPECT_GT(held, 10000U);
}

TEST(SpheresPeer, forces_torques_and_a_thousand_steps_are_those_lammps_found) {
    expect_what_the_peer_found(read_lammps_spheres(fs::path(DMP_SOURCE_DIR) / "tests/data/spheres_lammps.txt"));
}

TEST(SpheresPeer, lammps_on_this_machine_finds_the_same) {
    if (std::system("command -v lmp > /dev/null && command -v python3 > /dev/null") != 0)
        GTEST_SKIP() << "no lmp (Debian's package lammps) or no python3 on the path";
    const testing::TemporaryFolder folder;
    const fs::path reference = folder.path() / "reference.txt";
    const std::string script = std::string(DMP_SOURCE_DIR) + "/tests/peers/lammps_spheres/make_reference.py";
    ASSERT_EQ(std::system(("OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 python3 '" +
                           script + "' '" + reference.string() + "' '" + folder.path().string() + "'")
                              .c_str()),
              0);
    expect_what_the_peer_found(read_lammps_spheres(reference));
}

}  // namespace
}  // namespace dmp
