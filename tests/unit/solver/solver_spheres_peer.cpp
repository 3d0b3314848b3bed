// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/few_spheres.hpp"
#include "tests/unit/solver/lammps_spheres.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::solver_spheres_peer_tests {
namespace {

namespace fs = std::filesystem;
using V3 = Vector<double, 3>;
constexpr ContactModel as_lammps = model_of<HertzContact, PlainHistory, NoRolling, NoAdhesion>;

FewSpheres<as_lammps> spheres_of(const LammpsSpheres& peer) {
    FewSpheres<as_lammps> few;
    const LammpsSpheres::State& start = peer.start;
    for (std::size_t i = 0; i < peer.size(); ++i)
        few.spheres.push_back(
            {start.position[i], start.velocity[i], start.spin[i], peer.radius[i], peer.mass[i], V3{}, V3{}});
    few.pair = peer.pair;
    few.begin();
    return few;
}
std::vector<V3> of_all(const FewSpheres<as_lammps>& few, V3 Sphere::*quantity) {
    std::vector<V3> values;
    for (const Sphere& sphere : few.spheres) values.push_back(sphere.*quantity);
    return values;
}
/// Contacts at Coulomb's bound.
std::size_t sliding(const FewSpheres<as_lammps>& few) {
    std::size_t count = 0;
    for (const auto& [overlap, radius, force] : few.met) {
        const double bound = few.pair.friction * std::abs(force.normal);
        count += dot(force.tangential, force.tangential) > 0.999 * bound * bound ? 1 : 0;
    }
    return count;
}

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
    auto few = spheres_of(peer);
    EXPECT_GT(few.met.size(), 250U);
    expect_near_each(of_all(few, &Sphere::force), peer.start.force, 1e-9);
    expect_near_each(of_all(few, &Sphere::torque), peer.start.torque, 1e-9);

    std::size_t slid = 0, held = 0;
    for (int step = 0; step < peer.steps; ++step) {
        few.step(peer.dt);
        slid += sliding(few);
        held += few.met.size() - sliding(few);
    }
    const LammpsSpheres::State& end = peer.end;
    expect_near(of_all(few, &Sphere::position), end.position, 1e-6 * peer.radius[0], "position");
    expect_near(of_all(few, &Sphere::velocity), end.velocity, 1e-6 * largest(end.velocity), "velocity");
    expect_near(of_all(few, &Sphere::spin), end.spin, 1e-6 * largest(end.spin), "spin");
    expect_near(of_all(few, &Sphere::force), end.force, 1e-6 * largest(end.force), "force");
    expect_near(of_all(few, &Sphere::torque), end.torque, 1e-6 * largest(end.torque), "torque");
    EXPECT_GT(few.met.size(), 100U);
    EXPECT_GT(slid, 10000U);
    EXPECT_GT(held, 10000U);
}

TEST(SpheresPeer, forces_torques_and_a_thousand_steps_are_those_lammps_found) {
    expect_what_the_peer_found(read_lammps_spheres(fs::path(DMP_SOURCE_DIR) / "tests/data/spheres_lammps.txt"));
}

TEST(SpheresPeer, lammps_on_this_machine_finds_the_same) {
    if (std::system("command -v lmp > /dev/null && command -v python3 > /dev/null") != 0)
        GTEST_SKIP() << "no lmp (Debian's package lammps) or no python3 on the path";
    const TemporaryFolder folder;
    const fs::path reference = folder.path() / "reference.txt";
    const std::string script = std::string(DMP_SOURCE_DIR) + "/tests/peers/lammps_spheres/make_reference.py";
    ASSERT_EQ(std::system(("OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 python3 '" +
                           script + "' '" + reference.string() + "' '" + folder.path().string() + "'")
                              .c_str()),
              0);
    expect_what_the_peer_found(read_lammps_spheres(reference));
}

}  // namespace
}  // namespace dmp::tests::solver_spheres_peer_tests
