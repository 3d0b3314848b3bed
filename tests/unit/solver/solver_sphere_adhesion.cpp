// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "models/dem/contact_material.hpp"
#include "models/dem/contact_steps.hpp"
#include "models/dem/pull_off.hpp"
#include "solver/spheres/wall_law.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/few_spheres.hpp"

namespace dmp::tests::solver_sphere_adhesion_tests {
namespace {

using V3 = Vector<double, 3>;
constexpr ContactModel bradley = model_of<HertzContact, RescaledHistory, NoRolling, BradleyAdhesion>;
constexpr ContactModel dmt = model_of<HertzContact, RescaledHistory, NoRolling, DmtAdhesion>;
constexpr ContactModel jkr = model_of<JkrContact, RescaledHistory, NoRolling, NoAdhesion>;

// A drug particle of 5 um on a carrier of 100 um: 2.58e-7 N hold it.
constexpr double pull_off = 2.58e-7, radius = 2.5e-6 * 50 / 52.5, mass = 8.44e-14, z0 = 4e-10;
const ContactMaterial drug{2.15e9, 0.3}, carrier{63e9, 0.24};

ContactConstants<> drug_on_carrier(double range = 1) {
    ContactSettings settings;
    settings.adhesion_energy = BradleyAdhesion::adhesion_energy(pull_off, radius);
    settings.adhesion_distance = z0;
    settings.adhesion_range = range;
    return contact_constants(drug, carrier, settings);
}

/// The normal force on surfaces that overlap by this; `touched` where they did a step ago.
template <ContactModel model>
double force(double overlap, const ContactConstants<>& pair, bool touched = true, double effective_radius = radius) {
    using Law = ContactLaw<model>;
    typename Law::template History<double> history{};
    if constexpr (Law::keeps_touch) history.back() = touched ? 1e-9 : 0;
    return Law::law(Contact<double>{overlap, V3{{0, 0, 1}}, effective_radius, mass, 0, V3{}, V3{}}, pair, history, 1)
        .normal;
}

/// Work against the force from one overlap to a smaller one, by Simpson's rule in intervals that grow.
template <ContactModel model>
double work(double from, double to, const ContactConstants<>& pair) {
    constexpr int intervals = 20000;
    const auto overlap = [&](int k) { return from + z0 - z0 * std::pow(1 + (from - to) / z0, double(k) / intervals); };
    double sum = 0;
    for (int k = 0; k < intervals; ++k) {
        const double a = overlap(k), b = overlap(k + 1);
        sum -= (a - b) / 6 * (force<model>(a, pair) + 4 * force<model>((a + b) / 2, pair) + force<model>(b, pair));
    }
    return sum;
}

TEST(SphereAdhesion, bradley_pulls_as_much_as_dmt_in_contact_and_falls_off_with_the_gap) {
    const auto pair = drug_on_carrier();
    const double rest = std::pow(pull_off / (pair.normal_stiffness * std::sqrt(radius)), 2.0 / 3);
    EXPECT_NEAR(rest, 1.4454e-9, 0.002 * 1.4454e-9);
    EXPECT_NEAR(force<bradley>(rest, pair), 0, 1e-9 * pull_off);
    EXPECT_NEAR(force<bradley>(0, pair) / pull_off, -1, 1e-12);
    EXPECT_NEAR(force<bradley>(-0.5 * z0, pair) / pull_off, -1, 1e-12);
    for (const double ratio : {1.0, 1.2, 2.0, 10.0})
        EXPECT_NEAR(force<bradley>(-ratio * z0, pair) / pull_off,
                    4.0 / 3 * (0.25 * std::pow(ratio, -8) - std::pow(ratio, -2)), 1e-12);
    const auto cut = drug_on_carrier(2e-8);
    EXPECT_LT(force<bradley>(-1.999e-8, cut), 0);
    EXPECT_EQ(force<bradley>(-2.001e-8, cut), 0);
    EXPECT_EQ(ContactLaw<bradley>::reach(radius, cut), 2e-8);
}

TEST(SphereAdhesion, dmt_pulls_with_a_constant_force_while_surfaces_touch) {
    const auto pair = drug_on_carrier();
    EXPECT_NEAR(DmtAdhesion::pull_off(radius, pair) / pull_off, 1, 1e-12);
    EXPECT_EQ(DmtAdhesion::adhesion_energy(pull_off, radius), BradleyAdhesion::adhesion_energy(pull_off, radius));
    const double rest = DmtAdhesion::rest_overlap(radius, pair.normal_stiffness, pair.adhesion_energy);
    EXPECT_NEAR(force<dmt>(rest, pair), 0, 1e-9 * pull_off);
    for (const double overlap : {0.0, 0.1 * rest, rest, 3 * rest})
        EXPECT_NEAR(force<dmt>(overlap, pair) / pull_off, std::pow(overlap / rest, 1.5) - 1, 1e-12) << overlap;
    EXPECT_EQ(force<dmt>(-1e-15, pair), 0);
    EXPECT_EQ(ContactLaw<dmt>::reach(radius, pair), 0);
    EXPECT_NEAR(work<dmt>(rest, 0, pair),
                -(DmtAdhesion::energy(rest, radius, pair) + HertzContact::energy(rest, radius, pair)),
                1e-6 * pull_off * rest);
    EXPECT_GT(DmtAdhesion::energy(-1e-9, radius, pair), DmtAdhesion::energy(1e-9, radius, pair));
}

TEST(SphereAdhesion, of_dmt_and_bradley_are_one_in_contact) {
    const auto pair = drug_on_carrier();
    for (const double overlap : {0.0, 1e-10, 3e-9}) EXPECT_EQ(force<dmt>(overlap, pair), force<bradley>(overlap, pair));
}

TEST(ContactModels, are_all_there_and_consistent_ones_are_compiled) {
    std::size_t consistent = 0;
    for (std::size_t number = 0; number < contact_models; ++number) {
        EXPECT_EQ(number_of(contact_model(number)), number);
        if (!contact_model(number).is_consistent()) continue;
        ++consistent;
        EXPECT_NE(wall_law(contact_model(number)), nullptr);
        for (const VectorUnit unit : available_vector_units())
            EXPECT_NE(contact_sweep(contact_model(number), unit), nullptr) << number;
    }
    EXPECT_EQ(consistent, contact_models - 2 * TangentialLaws::size * RollingLaws::size);
    EXPECT_FALSE((model_of<JkrContact, RescaledHistory, NoRolling, DmtAdhesion>.is_consistent()));
}

/// Calls check.template operator()<model>() for every normal law with every adhesion that goes with it.
template <class Check>
void for_each_adhesion(const Check& check) {
    const auto with = [&]<class Normal, std::size_t... k>(std::index_sequence<k...>) {
        const auto one = [&]<class Adhesion>() {
            constexpr ContactModel model = model_of<Normal, RescaledHistory, NoRolling, Adhesion>;
            if constexpr (model.is_consistent()) check.template operator()<model>();
        };
        (one.template operator()<AdhesionLaws::Law<k>>(), ...);
    };
    const auto all = [&]<std::size_t... k>(std::index_sequence<k...>) {
        (with.template operator()<NormalLaws::Law<k>>(std::make_index_sequence<AdhesionLaws::size>{}), ...);
    };
    all(std::make_index_sequence<NormalLaws::size>{});
}

// What sums of loads are rounded by: each law's own pull-off force, found here along its curve.
TEST(ContactModels, attract_as_much_as_they_say) {
    const auto pair = drug_on_carrier();
    for_each_adhesion([&]<ContactModel model>() {
        const double reach = std::min(10 * z0, ContactLaw<model>::reach(radius, pair));
        double strongest = 0;
        for (int k = 0; k <= 100000; ++k) strongest = std::min(strongest, force<model>(-1e-5 * reach * k, pair));
        const std::string laws = to_string(model.normal) + " " + to_string(model.adhesion);
        EXPECT_NEAR(largest_attraction(model, radius, pair) / pull_off, -strongest / pull_off, 1e-6) << laws;
        EXPECT_EQ(largest_attraction(model, radius, pair) > 0, model.is_adhesive()) << laws;
    });
}

TEST(SphereAdhesion, bradley_takes_its_true_work) {
    const auto pair = drug_on_carrier();
    EXPECT_NEAR(work<bradley>(0, -1e-6, pair) / (pull_off * (16.0 / 7 * z0 - 4.0 / 3 * z0 * z0 / 1e-6)), 1, 1e-5);
    EXPECT_NEAR(work<bradley>(-z0, -1e-6, pair) / (pull_off * (9.0 / 7 * z0 - 4.0 / 3 * z0 * z0 / 1e-6)), 1, 1e-5);
    const auto cut = drug_on_carrier(2e-8);
    for (const double overlap : {2e-9, 0.0, -0.7 * z0, -3 * z0}) {
        const double stored =
            BradleyAdhesion::energy(overlap, radius, cut) + HertzContact::energy(overlap, radius, cut);
        EXPECT_NEAR(work<bradley>(overlap, -1.99999e-8, cut) / -stored, 1, 1e-4) << overlap;
    }
    EXPECT_NEAR(-BradleyAdhesion::energy(1e-9, radius, cut) / (pull_off * (1e-9 + 16.0 / 7 * z0)), 1, 0.006);
}

/// Whether a drug particle that is given this speed at rest leaves the carrier.
bool escapes(double speed, const ContactConstants<>& pair, double dt) {
    FewSpheres<bradley> few;
    few.floor = Floor{V3{{0, 0, 1}}, pair};
    const double rest = std::pow(pull_off / (pair.normal_stiffness * std::sqrt(radius)), 2.0 / 3);
    few.spheres = {{V3{{0, 0, radius - rest}}, V3{{0, 0, speed}}, V3{}, radius, mass}};
    few.begin();
    for (int step = 0; step * dt < 5e-6 && few.spheres[0].velocity[2] > 0; ++step) {
        few.step(dt);
        if (few.spheres[0].position[2] > radius + 2e-8) return true;
    }
    return false;
}

// Out of its well when m v^2 / 2 exceeds F_c (16/7 z0 + 3/5 d0): 0.1044 m/s.
TEST(SphereAdhesion, a_particle_escapes_at_the_speed_that_energy_gives) {
    for (const double range : {2e-8, 1.0})
        for (const double dt : {1e-11, 1e-9}) {
            double low = 0.05, high = 0.2;
            while (high - low > 1e-5)
                (escapes((low + high) / 2, drug_on_carrier(range), dt) ? high : low) = (low + high) / 2;
            EXPECT_NEAR(low, 0.1044, 0.01 * 0.1044) << range << " " << dt;
        }
}

TEST(SphereAdhesion, a_particle_swings_in_its_well_at_the_frequency_of_its_slope) {
    const auto pair = drug_on_carrier();
    FewSpheres<bradley> few;
    few.floor = Floor{V3{{0, 0, 1}}, pair};
    const double rest = std::pow(pull_off / (pair.normal_stiffness * std::sqrt(radius)), 2.0 / 3);
    few.spheres = {{V3{{0, 0, radius - 1.001 * rest}}, V3{}, V3{}, radius, mass}};
    few.begin();
    int turns = 0;
    double time = 0, sign = 1;
    while (turns < 20) {
        few.step(1e-10);
        time += 1e-10;
        const double speed = few.spheres[0].velocity[2];
        if (speed * sign < 0) ++turns, sign = -sign;
    }
    EXPECT_NEAR(20 * std::numbers::pi / time, 5.63e7, 0.003 * 5.63e7);
    EXPECT_NEAR(ContactTimes::at_rest(rest, radius, mass, pair), time / 20, 0.003 * time / 20);
}

TEST(SphereAdhesion, the_steepest_slope_of_bradleys_force_limits_the_step) {
    const auto pair = drug_on_carrier();
    double steepest = 0;
    for (int k = 0; k < 20000; ++k) {
        const double z = z0 + 1e-4 * z0 * k;
        steepest = std::max(steepest, (force<bradley>(-z - 1e-5 * z0, pair) - force<bradley>(-z, pair)) / (1e-5 * z0));
    }
    EXPECT_NEAR(BradleyAdhesion::stiffness(radius, pair) / steepest, 1, 1e-3);
    EXPECT_NEAR(BradleyAdhesion::stiffness(radius, pair), 662, 1);
    EXPECT_NEAR(ContactTimes::stable(BradleyAdhesion::stiffness(radius, pair), mass), 22.6e-9, 0.1e-9);
}

// Johnson, Kendall & Roberts (1971): largest pull 3/2 pi W R, 3/4 of DMT's; 8/9 of it without overlap; torn at -3
// a_c^2/R.
TEST(SphereAdhesion, jkr_pulls_three_quarters_of_dmt) {
    const auto pair = drug_on_carrier();
    const double reach = JkrContact::reach(radius, pair);
    double strongest = 0;
    for (int k = 0; k < 10000; ++k) strongest = std::min(strongest, force<jkr>(-1e-4 * reach * k, pair));
    EXPECT_NEAR(-strongest / pull_off, 0.75, 1e-6);
    EXPECT_NEAR(force<jkr>(1e-9 * reach, pair) / strongest, 8.0 / 9, 1e-6);
    EXPECT_NEAR(force<jkr>(-0.9999999 * reach, pair) / strongest, 5.0 / 9, 1e-3);
    EXPECT_EQ(force<jkr>(-1.0001 * reach, pair), 0);
    EXPECT_EQ(force<jkr>(-1e-3 * reach, pair, false), 0);
    const double e_star = 0.75 * pair.normal_stiffness, work_of_adhesion = pair.adhesion_energy;
    const double touch = std::cbrt(std::numbers::pi * work_of_adhesion * radius * radius / (8 * e_star));
    EXPECT_NEAR(reach, 3 * touch * touch / radius, 1e-9 * reach);
    EXPECT_EQ(ContactLaw<jkr>::reach(radius, pair), reach);
}

TEST(SphereAdhesion, jkr_solves_its_equations) {
    const auto pair = drug_on_carrier();
    const double e_star = 0.75 * pair.normal_stiffness, w = pair.adhesion_energy, pi = std::numbers::pi;
    const double reach = JkrContact::reach(radius, pair);
    for (const double overlap : {-0.999 * reach, -0.5 * reach, 0.0, 0.1 * reach, reach, 30 * reach, 1e4 * reach}) {
        const Contact<double> contact{overlap, V3{{0, 0, 1}}, radius, mass, 0, V3{}, V3{}};
        const auto [a, f, adhesive_force] = JkrContact::law(contact, pair, 1.0);
        const double deep = a * a / radius - std::sqrt(2 * pi * w * a / e_star);
        EXPECT_NEAR(deep, overlap, 1e-12 * (a * a / radius));
        const double pressed = 4 * e_star * a * a * a / (3 * radius);
        EXPECT_NEAR(f, pressed - std::sqrt(8 * pi * w * e_star * a * a * a), 1e-12 * (pressed + pull_off));
        EXPECT_NEAR(adhesive_force, 2 * 0.75 * pull_off, 1e-12 * pull_off);
        const double step = 1e-5 * (overlap + 1.1 * reach);
        EXPECT_NEAR(
            (JkrContact::energy(overlap + step, radius, pair) - JkrContact::energy(overlap - step, radius, pair)) /
                (2 * step),
            f, 1e-4 * (std::abs(f) + pull_off))
            << overlap / reach;
    }
    auto clean = pair;
    clean.adhesion_energy = 0;
    for (const double overlap : {1e-12, 1e-9, 1e-7}) {
        const double hertz = pair.normal_stiffness * std::sqrt(radius) * std::pow(overlap, 1.5);
        EXPECT_NEAR(force<jkr>(overlap, clean) / hertz, 1, 1e-9);
    }
    EXPECT_EQ(force<jkr>(-1e-12, clean), 0);
}

// A slow sphere is caught; a fast one loses what tears the surfaces apart: energy at the jump into contact less that of
// the jump out of it.
TEST(SphereAdhesion, jkr_holds_slow_spheres_and_slows_fast_ones) {
    const auto pair = drug_on_carrier();
    const auto rebound = [&](double speed) {
        FewSpheres<jkr> few;
        few.floor = Floor{V3{{0, 0, 1}}, pair};
        few.spheres = {{V3{{0, 0, radius}}, V3{{0, 0, -speed}}, V3{}, radius, mass}};
        few.begin();
        for (int step = 0; step < 100000 && few.spheres[0].position[2] < 1.02 * radius; ++step) few.step(2e-11);
        return few.spheres[0];
    };
    const double reach = JkrContact::reach(radius, pair);
    const double lost = JkrContact::energy(-reach, radius, pair) - JkrContact::energy(0, radius, pair);
    EXPECT_GT(lost, 0);
    const double limit = std::sqrt(2 * lost / mass);
    EXPECT_LT(rebound(0.98 * limit).position[2], 1.001 * radius);
    const double fast = rebound(3 * limit).velocity[2];
    EXPECT_NEAR(fast, limit * std::sqrt(8.0), 0.002 * fast);
}

// Friction rests on what presses: a contact that adhesion holds has friction without load.
TEST(SphereAdhesion, friction_holds_where_adhesion_presses) {
    auto pair = drug_on_carrier();
    pair.friction = 0.5;
    ContactLaw<bradley>::History<double> history{};
    const double rest = std::pow(pull_off / (pair.normal_stiffness * std::sqrt(radius)), 2.0 / 3);
    const Contact<double> contact{rest, V3{{0, 0, 1}}, radius, mass, 0, V3{{1, 0, 0}}, V3{}};
    EXPECT_NEAR(ContactLaw<bradley>::law(contact, pair, history, 1.0).tangential[0], -0.5 * pull_off, 1e-9 * pull_off);
}

}  // namespace
}  // namespace dmp::tests::solver_sphere_adhesion_tests
