// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "models/dem/contact_material.hpp"
#include "models/dem/contact_steps.hpp"
#include "models/dem/hertz.hpp"
#include "models/dem/restitution.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_contact_material_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const ContactMaterial drug{2.15e9, 0.3}, carrier{63e9, 0.24}, wall{infinity, 0.24};

TEST(ContactMaterial, hertz_and_mindlin_of_equal_and_unlike_materials) {
    const double e = 2.15e9, nu = 0.3, shear = e / (2 * (1 + nu));
    const auto equal = contact_constants(drug, drug, {});
    EXPECT_NEAR(equal.normal_stiffness / (2 * e / (3 * (1 - nu * nu))), 1, 1e-14);
    EXPECT_NEAR(equal.tangential_stiffness / (4 * shear / (2 - nu)), 1, 1e-14);
    EXPECT_NEAR(equal.normal_stiffness, 1.58e9, 0.01e9);
    EXPECT_NEAR(contact_constants(drug, carrier, {}).normal_stiffness, 3.04e9, 0.01e9);
    EXPECT_NEAR(
        contact_constants(carrier, drug, {}).normal_stiffness / contact_constants(drug, carrier, {}).normal_stiffness,
        1, 1e-15);
    EXPECT_NEAR(contact_constants(carrier, wall, {}).normal_stiffness, 8.92e10, 0.01e10);
    EXPECT_NEAR(contact_constants(carrier, carrier, {}).normal_stiffness, 4.46e10, 0.01e10);
    // A rigid wall: k_t / k_n = 3 (1 - nu) / (2 - nu).
    const auto rigid = contact_constants(carrier, wall, {});
    EXPECT_NEAR(rigid.tangential_stiffness / rigid.normal_stiffness, 3 * 0.76 / 1.76, 1e-14);
}

TEST(ContactMaterial, equations_7_5_and_7_6_of_the_thesis_by_name) {
    ContactSettings settings;
    settings.normal_stiffness_factor = 3;
    settings.tangential_stiffness_factor = 2;
    const double e = 2.15e9, nu = 0.3;
    const auto thesis = contact_constants(drug, drug, settings);
    EXPECT_NEAR(thesis.normal_stiffness / (2 * e / ((1 + nu) * (1 - nu))), 1, 1e-14);
    EXPECT_NEAR(thesis.tangential_stiffness / (4 * e / ((2 - nu) * (1 + nu))), 1, 1e-14);
    const auto right = contact_constants(drug, drug, {});
    EXPECT_NEAR(thesis.normal_stiffness / right.normal_stiffness, 3, 1e-14);
    EXPECT_NEAR(thesis.tangential_stiffness / right.tangential_stiffness, 2, 1e-14);
    // Contacts last 3^(-2/5) of the right time.
    EXPECT_NEAR(ContactTimes::impact(1e-6, 1e-14, 1, thesis) / ContactTimes::impact(1e-6, 1e-14, 1, right), 0.644,
                5e-4);
}

TEST(ContactMaterial, dampings_are_what_was_asked) {
    ContactSettings settings;
    EXPECT_EQ(contact_constants(drug, drug, settings).normal_dashpot, 0);
    EXPECT_EQ(contact_constants(drug, drug, settings).least_normal, -infinity);
    settings.damping = ContactDamping::restitution_no_pull;
    EXPECT_EQ(contact_constants(drug, drug, settings).normal_dashpot, 0);
    EXPECT_EQ(contact_constants(drug, drug, settings).least_normal, 0);
    settings.damping = ContactDamping::coefficients;
    settings.normal_rate = 0.3;
    settings.tangential_rate = 0.15;
    settings.restitution = 0.5;
    const auto rates = contact_constants(drug, drug, settings);
    EXPECT_EQ(rates.normal_dashpot, 0);
    EXPECT_EQ(rates.tangential_dashpot, 0);
    EXPECT_EQ(rates.normal_rate, 0.3);
    EXPECT_EQ(rates.tangential_rate, 0.15);
    // Tsuji, Tanaka & Ishida's law in its usual form: 2 sqrt(5/6) beta sqrt(S m), S_n = 2 E* a, S_t = 8 G* a.
    settings.damping = ContactDamping::restitution;
    const auto asked = contact_constants(drug, drug, settings);
    const double beta = std::log(2.0) / std::sqrt(std::pow(std::log(2.0), 2) + std::pow(std::acos(-1.0), 2));
    EXPECT_NEAR(asked.normal_dashpot / (2 * std::sqrt(5.0 / 6) * beta * std::sqrt(1.5 * asked.normal_stiffness)), 1,
                1e-14);
    EXPECT_NEAR(asked.tangential_dashpot / (2 * std::sqrt(5.0 / 6) * beta * std::sqrt(asked.tangential_stiffness)), 1,
                1e-14);
}

// What the ratios for a pulling dashpot give when its pull is cut off (Runge & Kutta, 4000 steps a contact).
TEST(ContactMaterial, restitution_without_pull_is_that_of_the_integrated_impact) {
    const std::vector<std::pair<double, double>> rows{{0.9, 0.9020}, {0.8, 0.8081}, {0.6, 0.6323}, {0.5, 0.5503},
                                                      {0.4, 0.4720}, {0.2, 0.3248}, {0.1, 0.2527}};
    for (const auto& [asked, found] : rows)
        EXPECT_NEAR(RestitutionDashpot::rebound(RestitutionDashpot::ratio_with_pull(asked)), found, 1e-4);
    for (const double asked : {1.0, 0.98, 0.9, 0.5, 0.2, 0.1353, std::exp(-2.0), 0.13, 0.1, 0.01, 1e-4})
        EXPECT_NEAR(RestitutionDashpot::rebound(RestitutionDashpot::ratio_without_pull(asked)) / asked, 1, 1e-6)
            << asked;
}

// The thesis' carrier on a rigid wall, and its drug particle's shear wave.
TEST(ContactMaterial, times_of_a_contact) {
    const auto pair = contact_constants(carrier, wall, {});
    struct Row {
        double speed, time, force;
    };
    for (const Row& row :
         {Row{1, 272e-9, 0.018}, Row{5, 197e-9, 0.122}, Row{7, 184e-9, 0.183}, Row{20, 149e-9, 0.645}}) {
        EXPECT_NEAR(ContactTimes::impact(50e-6, 1.31e-9, row.speed, pair), row.time, 0.7e-9);
        const double overlap = ContactTimes::largest_overlap(50e-6, 1.31e-9, row.speed, pair);
        EXPECT_NEAR(pair.normal_stiffness * std::sqrt(50e-6) * std::pow(overlap, 1.5), row.force, 0.03 * row.force);
        EXPECT_NEAR(HertzContact::energy(overlap, 50e-6, pair) / (0.5 * 1.31e-9 * row.speed * row.speed), 1, 1e-12);
    }
    EXPECT_NEAR(ContactTimes::impact(1, 1, 1, pair) / ContactTimes::largest_overlap(1, 1, 1, pair), 2.9432, 1e-4);
    EXPECT_NEAR(ContactTimes::rayleigh(2.5e-6, 1290, 2.15e9, 0.3), 10.6e-9, 0.1e-9);
}

TEST(ContactMaterial, wrong_values_are_named) {
    const auto message = [](const ContactMaterial& material, const std::function<void(ContactSettings&)>& change) {
        ContactSettings settings;
        change(settings);
        try {
            contact_constants(material, wall, settings);
        } catch (const InputError& error) {
            return error.problem() + "; " + error.what_to_do();
        }
        return std::string("no error");
    };
    const auto nothing = [](ContactSettings&) {};
    EXPECT_EQ(message({-1e9, 0.3}, nothing),
              "Young's modulus of a contact is -1e+09; give it a number above 0 [Pa], or infinity for a rigid wall");
    EXPECT_EQ(message({1e9, 0.6}, nothing),
              "Poisson's ratio of a contact is 0.6; give it a number above -1 and at most 0.5");
    EXPECT_EQ(message({1e9, -1}, nothing),
              "Poisson's ratio of a contact is -1; give it a number above -1 and at most 0.5");
    EXPECT_EQ(message(wall, nothing),
              "both materials of a contact are rigid; give one of them a finite Young's modulus");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(message({nan, 0.3}, nothing), "no error");
    EXPECT_NE(message({1e9, nan}, nothing), "no error");
    EXPECT_EQ(message(drug, [](ContactSettings& s) { s.restitution = 1.2; }),
              "the restitution of a contact is 1.2; give it a number above 0 and at most 1");
    EXPECT_NE(message(drug, [](ContactSettings& s) { s.restitution = 0; }), "no error");
    for (double ContactSettings::*value :
         {&ContactSettings::normal_rate, &ContactSettings::tangential_rate, &ContactSettings::friction,
          &ContactSettings::rolling_friction, &ContactSettings::rolling_damping, &ContactSettings::adhesion_energy,
          &ContactSettings::adhesion_distance, &ContactSettings::adhesion_range, &ContactSettings::restitution})
        for (const double wrong : {-1.0, nan, infinity})
            EXPECT_NE(message(drug, [&](ContactSettings& s) { s.*value = wrong; }), "no error");
    EXPECT_EQ(message(drug, [](ContactSettings& s) { s.friction = -0.5; }),
              "the friction of a contact is -0.5; give it 0 or a positive number");
    EXPECT_EQ(message(drug, [](ContactSettings& s) { s.adhesion_range = 1e-10; }),
              "the range of adhesion is 1e-10; give it a number above the distance of adhesion [m]");
    EXPECT_EQ(message(drug, nothing), "no error");
}

}  // namespace
}  // namespace dmp::tests::solver_contact_material_tests
