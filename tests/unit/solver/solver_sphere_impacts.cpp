// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "models/dem/contact_material.hpp"
#include "models/dem/contact_steps.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/few_spheres.hpp"

namespace dmp::tests::solver_sphere_impacts_tests {
namespace {

using V3 = Vector<double, 3>;
constexpr ContactModel standard = model_of<>;
constexpr ContactModel plain = model_of<HertzContact, PlainHistory, NoRolling, NoAdhesion>;
const ContactMaterial rigid{std::numeric_limits<double>::infinity(), 0.3};

double mass_of(double radius, double density) { return density * 4 / 3 * std::numbers::pi * std::pow(radius, 3); }

/// What is seen of an impact.
struct Seen {
    double overlap = 0, force = 0, duration = 0;  ///< largest overlap and force, steps in contact
    V3 velocity{}, spin{};                        ///< of the first sphere, afterwards
};

/// Steps until nothing touches any more.
template <ContactModel model>
Seen follow(FewSpheres<model>& few, double dt) {
    Seen seen;
    few.begin();
    for (bool touched = false; !touched || few.touching();) {
        few.step(dt);
        touched = touched || few.touching();
        if (!few.touching()) continue;
        seen.duration += dt;
        seen.overlap = std::max(seen.overlap, few.met[0].overlap);
        seen.force = std::max(seen.force, few.met[0].force.normal);
    }
    seen.velocity = few.spheres[0].velocity;
    seen.spin = few.spheres[0].spin;
    return seen;
}

/// A sphere that comes down on a rigid plane, `steps` to a contact.
struct Fall {
    double radius, density;
    ContactMaterial material;
    ContactSettings settings{};
    double speed = 1, degrees = 0;  ///< from the normal
    double steps = 400;
    double start = 0;  ///< part of a step before the plane

    template <ContactModel model = standard>
    [[nodiscard]] Seen land() const {
        FewSpheres<model> few;
        few.floor.emplace();
        few.floor->pair = contact_constants(material, rigid, settings);
        const double mass = mass_of(radius, density), angle = degrees * std::numbers::pi / 180;
        const double down = speed * std::cos(angle);
        const double dt = ContactTimes::impact(radius, mass, down, few.floor->pair) / steps;
        few.spheres = {
            {V3{{0, 0, radius + start * down * dt}}, V3{{speed * std::sin(angle), 0, -down}}, V3{}, radius, mass}};
        return follow(few, dt);
    }
};

const ContactMaterial aluminium_oxide{3.8e11, 0.23};
Fall fall_of_aluminium_oxide() { return {2.5e-3, 4000, aluminium_oxide, {}, 3.9}; }

// Chung & Ooi (Granul. Matter 13, 2011), test 1: two equal spheres, head on; and 2: one on a plane.

TEST(SphereImpacts, two_equal_elastic_spheres_as_in_chung_and_ooi_1) {
    struct Row {
        ContactMaterial material;
        double density, overlap, force, duration;
    };
    for (const Row& row : {Row{{4.8e10, 0.20}, 2800, 274.1e-6, 10.70e3, 40.3e-6},
                           Row{{2.0e10, 0.25}, 2500, 368.3e-6, 7.11e3, 54.2e-6}}) {
        FewSpheres<standard> few;
        ContactSettings settings;
        settings.friction = 0.35;
        few.pair = contact_constants(row.material, row.material, settings);
        const double mass = mass_of(0.01, row.density);
        few.spheres = {{V3{{0.01, 0, 0}}, V3{{-10, 0, 0}}, V3{}, 0.01, mass},
                       {V3{{-0.01, 0, 0}}, V3{{10, 0, 0}}, V3{}, 0.01, mass}};
        const Seen seen = follow(few, row.duration / 400);
        EXPECT_NEAR(seen.overlap / row.overlap, 1, 0.001);
        EXPECT_NEAR(seen.force / row.force, 1, 0.001);
        EXPECT_NEAR(seen.duration / row.duration, 1, 0.005);
        EXPECT_NEAR(seen.velocity[0], 10, 1e-5);
    }
}

TEST(SphereImpacts, elastic_spheres_on_a_plane_as_in_chung_and_ooi_2_and_3) {
    struct Row {
        Fall fall;
        double overlap, force, duration;
    };
    for (const Row& row : {Row{{0.1, 2699, {7.0e10, 0.30}, {}, 0.2}, 49.72e-6, 11.37e3, 731.6e-6},
                           Row{{0.1, 1800, {4.0e10, 0.35}, {}, 0.2}, 52.12e-6, 7.23e3, 767.0e-6},
                           Row{fall_of_aluminium_oxide(), 8.089e-6, 615.4, 6.104e-6},
                           Row{{2.5e-3, 7000, {1.0e11, 0.25}, {}, 3.9}, 17.19e-6, 506.8, 12.97e-6}}) {
        const Seen seen = row.fall.land();
        EXPECT_NEAR(seen.overlap / row.overlap, 1, 0.001);
        EXPECT_NEAR(seen.force / row.force, 1, 0.001);
        EXPECT_NEAR(seen.duration / row.duration, 1, 0.005);
        EXPECT_NEAR(seen.velocity[2] / row.fall.speed, 1, 1e-6);
    }
}

TEST(SphereImpacts, rebound_with_the_restitution_asked) {
    for (const ContactDamping damping : {ContactDamping::restitution, ContactDamping::restitution_no_pull})
        for (const double restitution : {0.98, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1}) {
            Fall fall = fall_of_aluminium_oxide();
            fall.settings.damping = damping;
            fall.settings.restitution = restitution;
            EXPECT_NEAR(fall.land().velocity[2] / fall.speed / restitution, 1, 0.005) << restitution;
            fall.speed = 0.01;
            EXPECT_NEAR(fall.land().velocity[2] / fall.speed / restitution, 1, 0.005) << restitution;
        }
}

// A step later or earlier at the start of the contact is a part of the answer when steps are few.
TEST(SphereImpacts, few_steps_give_the_restitution_on_average) {
    for (const ContactDamping damping : {ContactDamping::restitution, ContactDamping::restitution_no_pull})
        for (const double restitution : {0.98, 0.8, 0.6, 0.4, 0.2, 0.1}) {
            Fall fall = fall_of_aluminium_oxide();
            fall.settings.damping = damping;
            fall.settings.restitution = restitution;
            fall.steps = StepsPerContact::standard;
            double mean = 0;
            for (int start = 0; start < 20; ++start) {
                fall.start = (start + 0.5) / 20;
                const double found = fall.land().velocity[2] / fall.speed;
                EXPECT_NEAR(found, restitution, 0.003) << restitution;
                mean += found / 20;
            }
            EXPECT_NEAR(mean, restitution, 5e-4);
        }
}

TEST(SphereImpacts, steps_per_contact_are_as_accurate_as_they_say) {
    Fall fall = fall_of_aluminium_oxide();
    const auto worst = [&](double steps) {
        fall.steps = steps;
        double error = 0;
        for (int start = 0; start < 10; ++start) {
            fall.start = (start + 0.5) / 10;
            error = std::max(error, std::abs(fall.land().velocity[2] / fall.speed - 1));
        }
        return error;
    };
    EXPECT_LT(worst(StepsPerContact::draft), 1e-3);
    EXPECT_LT(worst(StepsPerContact::standard), 2e-4);
    EXPECT_LT(worst(StepsPerContact::fine), 2e-5);
}

/// Errors over the speed of an impact: of the speed after it, and of the spin as the surface's speed.
struct Errors {
    double speed = 0, spin = 0;
};
/// Steps are those of the scene's limit, which sees the whole speed.
Errors errors_of_oblique_impacts(double steps, double restitution) {
    Errors worst;
    for (const double friction : {0.1, 0.3, 0.5, 1.0, 2.0})
        for (const double degrees : {5.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0}) {
            Fall fall = fall_of_aluminium_oxide();
            fall.settings.friction = friction;
            fall.settings.restitution = restitution;
            fall.degrees = degrees;
            const double longer = std::pow(std::cos(degrees * std::numbers::pi / 180), -0.2);
            const auto after = [&](double many) {
                fall.steps = many * longer;
                return fall.land();
            };
            fall.start = 0.5;
            const Seen exact = after(2000);
            for (const double start : {0.1, 0.3, 0.5, 0.7, 0.9}) {
                fall.start = start;
                const Seen seen = after(steps);
                const auto speed = [](const Seen& of) { return std::sqrt(dot(of.velocity, of.velocity)); };
                worst.speed = std::max(worst.speed, std::abs(speed(seen) - speed(exact)) / fall.speed);
                worst.spin = std::max(worst.spin, fall.radius * std::abs(seen.spin[1] - exact.spin[1]) / fall.speed);
            }
        }
    return worst;
}

// docs/contact.md has the table.
TEST(SphereImpacts, oblique_ones_are_right_to_one_percent_and_of_second_order) {
    for (const double restitution : {1.0, 0.9, 0.7, 0.5, 0.3}) {
        const Errors found = errors_of_oblique_impacts(StepsPerContact::standard, restitution);
        EXPECT_LT(found.speed, 0.0025) << restitution;
        EXPECT_LT(found.spin, 0.006) << restitution;
        EXPECT_LT(found.spin, 1.15 * StepsPerContact::error(StepsPerContact::standard)) << restitution;
        EXPECT_LT(errors_of_oblique_impacts(2 * StepsPerContact::standard, restitution).spin, found.spin / 2.4)
            << restitution;
        EXPECT_LT(errors_of_oblique_impacts(StepsPerContact::draft, restitution).spin, 0.025) << restitution;
        EXPECT_LT(errors_of_oblique_impacts(StepsPerContact::fine, restitution).spin, 0.0015) << restitution;
    }
}

// What is held has no velocity: Coulomb's limit, and a pull-off force, must not depend on the dashpot and the step.
TEST(SphereImpacts, what_rests_is_held_up_to_the_limit_whatever_the_dashpot) {
    Contact<double> contact{};
    contact.overlap = 1e-6;
    contact.radius = 1e-3;
    contact.mass = 1e-6;
    contact.normal = V3{{0, 0, 1}};
    const ShearContact<double> shear{std::sqrt(1e-9), std::pow(1e-9, 0.25), 1e7, 0.5, 3};
    const double dt = 1e-6;  // the dashpot times dt is more than the mass that moves
    V3 kept{{1, 0, 0}};
    for (int k = 0; k < 3; ++k) {
        const Shear<double> held = RescaledHistory::law(contact, shear, kept, dt);
        EXPECT_NEAR(held.force[0], -shear.largest, 1e-12 * shear.largest);
        kept = held.kept;
    }
    ContactSettings settings;
    settings.restitution = 0.1;
    settings.adhesion_energy = 0.05;
    const ContactConstants<> pair = contact_constants({1e7, 0.3}, {1e7, 0.3}, settings);
    using Law = ContactLaw<model_of<JkrContact>>;
    contact.overlap = -0.9 * JkrContact::reach(contact.radius, pair);
    const auto pull = [&](double step) {
        Law::History<double> history{};
        history.back() = 1e-5;
        return Law::law(contact, pair, history, step).normal;
    };
    EXPECT_LT(pull(0), 0);
    EXPECT_EQ(pull(1e-5), pull(0));
}

// Dampings from coefficients, in units of length (m v^2 / (k sqrt R))^(2/5) and of that length over v, where F =
// sqrt(d) (d - G d') until d = 0, or cut off at 0: integrated to 1e-6 with Runge & Kutta's method.
TEST(SphereImpacts, coefficients_give_the_damped_impact) {
    struct Row {
        double damping, restitution, duration, overlap, cut_off;
    };
    for (const Row& row : {Row{0, 1.00000, 3.21807, 1.09336, 1.00000}, Row{0.01, 0.98854, 3.22180, 1.08835, 0.98855},
                           Row{0.05, 0.94426, 3.23715, 1.06883, 0.94440}, Row{0.1, 0.89215, 3.25729, 1.04560, 0.89286},
                           Row{0.2, 0.79755, 3.30078, 1.00262, 0.80097}, Row{0.5, 0.57382, 3.45835, 0.89588, 0.59525},
                           Row{1, 0.33116, 3.82845, 0.76748, 0.39393}, Row{2, 0.09533, 5.24527, 0.60767, 0.21165}}) {
        const auto impact = [&](double least) {
            FewSpheres<standard> few;
            few.floor.emplace();
            few.floor->pair.normal_stiffness = 1;
            few.floor->pair.normal_rate = row.damping;
            few.floor->pair.least_normal = least;
            few.spheres = {{V3{{0, 0, 1}}, V3{{0, 0, -1}}, V3{}, 1, 1}};
            return follow(few, row.duration / 2000);
        };
        const Seen pulled = impact(-std::numeric_limits<double>::infinity());
        EXPECT_NEAR(pulled.velocity[2], row.restitution, 0.001 * row.restitution) << row.damping;
        EXPECT_NEAR(pulled.duration / row.duration, 1, 0.002) << row.damping;
        EXPECT_NEAR(pulled.overlap / row.overlap, 1, 0.001) << row.damping;
        EXPECT_NEAR(impact(0).velocity[2], row.cut_off, 0.001 * row.cut_off) << row.damping;
    }
}

// Chung & Ooi, test 4: oblique impacts. While the surfaces slide all along, for tan > 7/2 mu (1 + e),
//   v_t' / v_t = 1 - mu (1 + e) v_n / v_t,   omega' = 5/2 mu (1 + e) v_n / R
TEST(SphereImpacts, oblique_impacts_as_in_chung_and_ooi_4) {
    for (const auto& [material, density] : {std::pair{aluminium_oxide, 4000.0}, {ContactMaterial{7e10, 0.33}, 2700.0}})
        for (const double degrees : {35.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
            Fall fall{2.5e-3, density, material, {}, 3.9, degrees};
            fall.settings.restitution = 0.98;
            fall.settings.friction = 0.092;
            const double angle = degrees * std::numbers::pi / 180;
            const double across = 3.9 * std::sin(angle), down = 3.9 * std::cos(angle), slowed = 0.092 * 1.98 * down;
            const Seen seen = fall.land();
            EXPECT_NEAR(seen.velocity[2] / (0.98 * down), 1, 0.005) << degrees;
            EXPECT_NEAR(seen.velocity[0] / across, 1 - slowed / across, 0.005) << degrees;
            EXPECT_NEAR(seen.spin[1] / (2.5 * slowed / 2.5e-3), 1, 0.005) << degrees;
            EXPECT_EQ(seen.velocity[1], 0);
            fall.steps = StepsPerContact::standard;
            EXPECT_NEAR(fall.land().velocity[0] / across, 1 - slowed / across, 0.005) << degrees;
        }
}

// The same test's curve for aluminium oxide below that, as other codes' tests have digitised it.
TEST(SphereImpacts, steep_impacts_lie_near_the_curve_of_chung_and_ooi_4) {
    const std::pair<double, double> curve[] = {{5, 0.948},  {10, 0.687}, {15, 0.624},
                                               {20, 0.616}, {25, 0.634}, {30, 0.684}};
    for (const auto& [degrees, kept] : curve) {
        Fall fall{2.5e-3, 4000, aluminium_oxide, {}, 3.9, degrees};
        fall.settings.restitution = 0.98;
        fall.settings.friction = 0.092;
        const double across = 3.9 * std::sin(degrees * std::numbers::pi / 180);
        const double tolerance = degrees < 12 ? 0.03 : 0.01;
        EXPECT_NEAR(fall.land().velocity[0] / across, kept, tolerance) << degrees;
        EXPECT_NEAR(fall.land<plain>().velocity[0] / across, kept, tolerance) << degrees;
    }
}

TEST(SphereImpacts, of_unlike_spheres_keep_both_momenta) {
    FewSpheres<standard> few;
    ContactSettings settings;
    settings.restitution = 0.7;
    settings.friction = 0.3;
    few.pair = contact_constants(aluminium_oxide, {7e10, 0.33}, settings);
    few.spheres = {{V3{{0, 0, 0}}, V3{{0.4, 0.1, -0.2}}, V3{{20, -300, 50}}, 1e-3, mass_of(1e-3, 4000)},
                   {V3{{3e-3, 0, 0}}, V3{{-3, 0.5, 1}}, V3{{-100, 30, 200}}, 2e-3, mass_of(2e-3, 2700)}};
    const auto momenta = [&] {
        V3 straight{}, angular{};
        for (const Sphere& s : few.spheres) {
            straight += s.mass * s.velocity;
            angular += s.mass * cross(s.position, s.velocity) + (0.4 * s.mass * s.radius * s.radius) * s.spin;
        }
        return std::pair{straight, angular};
    };
    const auto [straight, angular] = momenta();
    const V3 spin = few.spheres[0].spin;
    follow(few, 1e-8);
    const auto [straight_after, angular_after] = momenta();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(straight_after[axis], straight[axis], 1e-13 * 3e-4);
        EXPECT_NEAR(angular_after[axis], angular[axis], 1e-13 * 6e-7);
    }
    EXPECT_GT(std::abs(few.spheres[0].spin[2] - spin[2]), 20);
}

}  // namespace
}  // namespace dmp::tests::solver_sphere_impacts_tests
