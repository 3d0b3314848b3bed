// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic bodies that touch as their drawn surfaces in 3-D.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::solver_contact_in_space_tests {
namespace {

struct Ran {
    RunSummary summary;

    [[nodiscard]] double last(const std::string& column) const {
        const auto found = std::ranges::find(summary.measures.names, column);
        if (found == summary.measures.names.end()) throw std::logic_error("no column " + column);
        return summary.measures.rows.back().at(static_cast<std::size_t>(found - summary.measures.names.begin()));
    }
    [[nodiscard]] Vec velocity(const std::string& body) const {
        return {last(body + "_velocity_x"), last(body + "_velocity_y"), last(body + "_velocity_z")};
    }
};

Ran run(const Texts& texts) {
    const Meshed meshed = mesh_texts(texts);
    return {Simulation(meshed.scene, meshed.particles, Resources(1)).run({})};
}

std::string scene_with(const std::string& parts, const std::string& duration, const std::string& more) {
    return "schema = 1\ntitle = \"contact\"\ndimension = 3\n[geometry]\nfile = \"channel.geo\"\nunit = \"1 "
           "mm\"\n[particles]\nspacing = \"0.75 mm\"\n" +
           parts + "[flow]\nlargest_speed = \"0.5 m/s\"\n[run]\nduration = \"" + duration + "\"\n[output]\nevery = \"" +
           duration + "\"\n" + more;
}

std::string part(const std::string& name, const std::string& modulus, const std::string& more) {
    return "[[part]]\nname = \"" + name +
           "\"\nkind = \"elastic\"\nmodel = \"cells\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"" + modulus +
           "\"\npoisson_ratio = 0.25\n" + more;
}

std::string body_measure(const std::string& name) {
    return "[[measure]]\nname = \"" + name + "\"\nkind = \"body\"\npart = \"" + name + "\"\n";
}

/// Hertz' law for two smooth balls, integrated beside it: they leave with (-+0.1959, -+0.0346, -+0.0208) m/s.
TEST(ContactInSpace, lets_smooth_balls_meet_as_hertz_says) {
    const Ran ran =
        run({scene_with(part("a", "1 MPa", "initial_velocity = [\"0.2 m/s\", 0, 0]\n") +
                            part("b", "1 MPa", "initial_velocity = [\"-0.2 m/s\", 0, 0]\n"),
                        "7 ms", body_measure("a") + body_measure("b")),
             "SetFactory(\"OpenCASCADE\");\nSphere(1) = {5, 5, 5, 3};\nSphere(2) = {12, 5.5, 5.3, "
             "3};\nPhysical Volume(\"a\") = {1};\nPhysical Volume(\"b\") = {2};\nMesh.MeshSizeMax = 0.4;\n"});
    const Vec a = ran.velocity("a"), b = ran.velocity("b");
    EXPECT_NEAR(a.norm(), 0.2, 0.01 * 0.2);
    EXPECT_NEAR(a[0], -0.1959, 0.02 * 0.1959);
    EXPECT_NEAR(a[1], -0.0346, 0.1 * 0.0346);  // eight spacings across a ball
    EXPECT_NEAR(a[2], -0.0208, 0.16 * 0.0208);
    EXPECT_LT((a + b).norm(), 0.004);  // not of equal mass on their lattices
    EXPECT_LT(ran.summary.momentum_residual, 1e-12);
    ASSERT_TRUE(ran.summary.contact);
    EXPECT_LT(ran.summary.contact->depth, 0.1 * 0.75e-3);
}

/// A block of 6 x 6 x 3 mm on a slab that is held at its lower side, in gravity of 10 m/s^2 across it and 2 m/s^2
/// along.
Texts slide(const std::string& friction, const std::string& pull, const std::string& more) {
    const Texts texts{
        scene_with(part("floor", "0.2 MPa", "anchor = \"held\"\n") + part("block", "0.2 MPa", ""), "0.02 s",
                   "[contact]\nfriction = " + friction + "\n" + more + body_measure("block")),
        "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 15, 9, 1.5};\nBox(2) = {2.1, 1.4, 1.5, 6, 6, 3};\nPhysical "
        "Volume(\"floor\") = {1};\nPhysical Volume(\"block\") = {2};\nPhysical Surface(\"held\") = "
        "{5};\nMesh.MeshSizeMax = 0.8;\n"};
    return texts.with("[flow]\n", "[flow]\nacceleration = [\"" + pull + " m/s^2\", 0, \"-10 m/s^2\"]\n");
}

TEST(ContactInSpace, slides_without_friction_and_as_coulomb_says) {
    const Ran smooth = run(slide("0", "2", ""));
    EXPECT_NEAR(smooth.last("block_velocity_x"), 2 * 0.02, 0.01 * 0.04);
    EXPECT_NEAR(smooth.last("block_velocity_y"), 0, 0.0006);
    const Ran rough = run(slide("0.3", "5", ""));
    EXPECT_NEAR(rough.last("block_velocity_x"), 2 * 0.02, 0.03 * 0.04);
    const Ran sticks = run(slide("0.3", "2", "damping = 0.2\n"));
    EXPECT_NEAR(sticks.last("block_velocity_x"), 0, 0.002);
    EXPECT_LT(smooth.summary.momentum_residual, 1e-12);
    EXPECT_LT(rough.summary.momentum_residual, 1e-12);
}

/// Hertz 1882; Johnson 1985, section 4.2: a ball on a plane, a = (3 P R / (4 E*))^(1/3), p0 = 3 P / (2 pi a^2).
TEST(ContactInSpace, touches_in_the_circle_that_hertz_gives) {
    const std::string still = "mass_damping = \"2000 1/s\"\n";
    const double load = 0.6, radius = 4e-3, modulus = 1e6 / (2 * (1 - 0.25 * 0.25));
    const Ran ran =
        run({scene_with(part("ball", "1 MPa", still) + part("slab", "1 MPa", still + "anchor = \"held\"\n"), "8 ms",
                        "[[force]]\nname = \"press\"\npart = \"ball\"\namount = \"total\"\nforce = [0, 0, "
                        "\"-0.6 N\"]\n[[measure]]\nname = \"c\"\nkind = \"contact\"\npart = \"ball\"\n"),
             "SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 4, 4};\nBox(2) = {-6, -6, -6, 12, 12, "
             "6};\nPhysical Volume(\"ball\") = {1};\nPhysical Volume(\"slab\") = {2};\nPhysical "
             "Surface(\"held\") = {6};\nMesh.MeshSizeMax = 0.5;\n"});
    const double across = std::pow(3 * load * radius / (4 * modulus), 1.0 / 3);
    EXPECT_NEAR(ran.last("c_force_z"), load, 0.01 * load);
    EXPECT_NEAR(ran.last("c_area"), std::numbers::pi * across * across, 0.03 * std::numbers::pi * across * across);
    EXPECT_NEAR(ran.last("c_pressure"), 1.5 * load / (std::numbers::pi * across * across),
                0.05 * 1.5 * load / (std::numbers::pi * across * across));
}

}  // namespace
}  // namespace dmp::tests::solver_contact_in_space_tests
