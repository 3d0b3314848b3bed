// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "models/dem/contact_material.hpp"
#include "models/dem/contact_steps.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/few_spheres.hpp"

namespace dmp::tests::solver_sphere_friction_tests {
namespace {

using V3 = Vector<double, 3>;
constexpr ContactModel standard = model_of<>;
constexpr ContactModel plain = model_of<HertzContact, PlainHistory, NoRolling, NoAdhesion>;
constexpr ContactModel constant_rolling = model_of<HertzContact, RescaledHistory, ConstantRolling, NoAdhesion>;
constexpr ContactModel rolling_spring = model_of<HertzContact, RescaledHistory, RollingSpring, NoAdhesion>;
const ContactMaterial rigid{std::numeric_limits<double>::infinity(), 0.3};

/// A steel-hard ball of 1 cm at rest on a floor that slopes upwards along -x.
template <ContactModel model>
struct Ball {
    static constexpr double radius = 0.01, mass = 0.01, g = 9.81;
    FewSpheres<model> few;
    double dt = 0;

    explicit Ball(const ContactSettings& settings, double slope = 0) {
        few.floor.emplace();
        few.floor->pair = contact_constants({1e9, 0.3}, rigid, settings);
        few.gravity = V3{{g * std::sin(slope), 0, -g * std::cos(slope)}};
        const double weight = mass * g * std::cos(slope);
        const double overlap = std::pow(weight / (few.floor->pair.normal_stiffness * std::sqrt(radius)), 2.0 / 3);
        few.spheres = {{V3{{0, 0, radius - overlap}}, V3{}, V3{}, radius, mass}};
        dt = ContactTimes::at_rest(overlap, radius, mass, few.floor->pair) / StepsPerContact::standard;
    }
    Sphere& ball() { return few.spheres[0]; }
    void run(double time) {
        few.begin();
        for (int step = 0; step < time / dt; ++step) few.step(dt);
    }
};

// A ball pushed off without spin slides until t = 2 v0 / (7 mu g), then rolls with 5/7 v0.
TEST(SphereFriction, sliding_turns_into_rolling) {
    ContactSettings settings;
    settings.friction = 0.3;
    settings.restitution = 0.5;
    const double until = 2 * 1.0 / (7 * 0.3 * 9.81);
    Ball<standard> ball(settings);
    ball.ball().velocity[0] = 1;
    ball.run(until / 2);
    EXPECT_NEAR(ball.ball().velocity[0], 1 - 0.3 * 9.81 * until / 2, 0.001);
    EXPECT_NEAR(ball.ball().spin[1] * 0.01, 2.5 * 0.3 * 9.81 * until / 2, 0.001);
    ball.run(until * 0.48);
    EXPECT_GT(ball.ball().velocity[0], ball.ball().spin[1] * 0.01 + 0.01);
    ball.run(until);
    EXPECT_NEAR(ball.ball().velocity[0], 5.0 / 7, 0.001 * 5 / 7);
    EXPECT_NEAR(ball.ball().spin[1] * 0.01, 5.0 / 7, 0.001 * 5 / 7);
}

TEST(SphereFriction, rolling_without_rolling_friction_goes_on) {
    ContactSettings settings;
    settings.friction = 0.3;
    Ball<standard> ball(settings);
    ball.ball().velocity[0] = 1;
    ball.ball().spin[1] = 100;
    ball.run(0.2);
    EXPECT_NEAR(ball.ball().velocity[0], 1, 1e-3);
}

// A torque of mu_r R m g: d omega/dt = 5/2 mu_r g / R where nothing else turns it, 5/7 of that over R on the roll.
template <ContactModel model>
void expect_rolling_to_decay() {
    ContactSettings settings;
    settings.rolling_friction = 0.02;
    Ball<model> spinning(settings);
    spinning.ball().spin[1] = 100;
    spinning.run(0.5);
    EXPECT_NEAR(100 - spinning.ball().spin[1], 2.5 * 0.02 * 9.81 * 0.5 / 0.01, 0.001 * 24.5);

    settings.friction = 0.5;
    Ball<model> rolling(settings);
    rolling.ball().spin[1] = 100;
    rolling.ball().velocity[0] = 1;
    rolling.run(0.5);
    EXPECT_NEAR(1 - rolling.ball().velocity[0], 5.0 / 7 * 0.02 * 9.81 * 0.5, 0.001);
    rolling.run(8);
    EXPECT_NEAR(rolling.ball().velocity[0], 0, 1e-4);
    EXPECT_NEAR(rolling.ball().spin[1] * 0.01, 0, 1e-4);
}
TEST(SphereFriction, rolling_decays_under_a_constant_torque) { expect_rolling_to_decay<constant_rolling>(); }
TEST(SphereFriction, rolling_decays_under_a_yielding_spring) { expect_rolling_to_decay<rolling_spring>(); }

// The spring holds a ball on slopes of up to mu_r.
TEST(SphereFriction, a_rolling_spring_holds_on_a_slope) {
    const auto gone = [](auto model, double slope) {
        ContactSettings settings;
        settings.friction = 0.8;
        settings.rolling_friction = 0.1;
        settings.restitution = 0.5;
        Ball<model()> ball(settings, slope);
        ball.run(0.5);
        const double after = ball.ball().position[0];
        ball.run(1);
        return ball.ball().position[0] - after;
    };
    using Spring = std::integral_constant<ContactModel, rolling_spring>;
    using Constant = std::integral_constant<ContactModel, constant_rolling>;
    EXPECT_NEAR(gone(Spring{}, 0.09), 0, 1e-6);
    EXPECT_GT(gone(Spring{}, 0.12), 0.05);
    EXPECT_GT(gone(Constant{}, 0.12), 0.05);
}

/// Closed path: sheared where the contact is small, drawn back where it is large. Work done on the contact [J].
template <ContactModel model>
double work_around(bool shear_while_small) {
    using Law = ContactLaw<model>;
    ContactConstants<> pair;
    pair.normal_stiffness = 1;
    pair.tangential_stiffness = 1;
    pair.friction = 1e9;
    typename Law::template History<double> history{};
    Contact<double> contact{1, V3{{0, 0, 1}}, 1, 1, 0, V3{}, V3{}};
    double work = 0;
    V3 last{};
    const auto go = [&](double deeper, double along) {
        for (int k = 0; k < 1000; ++k) {
            contact.overlap += deeper / 1000;
            contact.slip = V3{{along / 1000, 0, 0}};
            const V3 force = Law::law(contact, pair, history, 1).tangential;
            work -= 0.5 * (force[0] + last[0]) * along / 1000;
            last = force;
        }
    };
    const double first = shear_while_small ? 0.01 : -0.01;
    go(0, 0);
    go(0, first);
    go(3, 0);
    go(0, -first);
    go(-3, 0);
    return work;
}

// Elata & Berryman (Mech. Mater. 24, 1996): history of one displacement gives work away at every turn.
TEST(SphereFriction, a_closed_path_gives_no_work_where_history_is_rescaled) {
    const double spring = 0.5 * 1 * 0.01 * 0.01;
    EXPECT_NEAR(work_around<plain>(true), -spring, 0.01 * spring);
    EXPECT_GT(work_around<standard>(true), 0);
}

/// A carrier particle of 100 um meets a wall whose dashpots are far stronger than a step can follow.
struct StickyImpact {
    double speed, degrees, normal_rate, tangential_rate;
    static constexpr double radius = 50e-6, mass = 1.31e-9, friction = 0.3;

    /// Steps of 1 ns; says what is wrong.
    void run() const {
        ContactSettings settings;
        settings.damping = ContactDamping::coefficients;
        settings.normal_rate = normal_rate;
        settings.tangential_rate = tangential_rate;
        settings.friction = friction;
        FewSpheres<standard> few;
        few.floor.emplace();
        few.floor->pair = contact_constants({63e9, 0.24}, rigid, settings);
        const double angle = degrees * std::numbers::pi / 180;
        const V3 velocity{{speed * std::sin(angle), 0, -speed * std::cos(angle)}};
        few.spheres = {{V3{{0, 0, radius}}, velocity, V3{}, radius, mass}};
        few.begin();
        const Sphere& sphere = few.spheres[0];
        const auto across = [&] {
            const double turning = radius * sphere.spin[1];
            return sphere.velocity[0] * sphere.velocity[0] + 0.4 * turning * turning;
        };
        const auto down = [&] {
            const double square = sphere.velocity[2] * sphere.velocity[2];
            return few.met.empty()
                       ? square
                       : square + 2 / mass * HertzContact::energy(few.met[0].overlap, radius, few.floor->pair);
        };
        double last_across = across(), last_down = down();
        bool stuck = false;
        for (int step = 0; step < 3000; ++step) {
            few.step(1e-9);
            ASSERT_LE(across(), last_across + 1e-5 * speed * speed) << step;
            ASSERT_LE(down(), last_down + 1e-3 * speed * speed) << step;
            last_across = across();
            last_down = down();
            if (!few.touching()) continue;
            const double slip = sphere.velocity[0] - sphere.spin[1] * (radius - few.met[0].overlap);
            EXPECT_GT(slip, -1e-3 * speed) << step;
            stuck = stuck || slip < 1e-3 * speed;
            EXPECT_LT(slip, stuck ? 2e-3 * speed : 2 * speed) << step;
        }
        EXPECT_EQ(stuck, degrees < 40);
        EXPECT_LT(std::abs(sphere.velocity[2]), 0.05 * speed);
    }
};

// 6e14 and 6e20 / (m s) are in the literature for such a wall: 1e5 and more per step.
TEST(SphereFriction, a_dashpot_of_any_strength_is_stable) {
    for (const double speed : {1.0, 10.0, 20.0})
        for (const double degrees : {0.0, 10.0, 30.0, 60.0, 85.0})
            for (const auto& [normal, tangential] : {std::pair{6e14, 6e20}, {6e18, 6e20}, {6e18, 6e26}}) {
                SCOPED_TRACE(::testing::Message()
                             << speed << " m/s, " << degrees << " degrees, " << normal << ", " << tangential);
                StickyImpact{speed, degrees, normal, tangential}.run();
            }
}

/// Kinetic and stored energy of a sphere on its floor.
template <ContactModel model>
double energy(FewSpheres<model>& few) {
    using Shear = std::conditional_t<model.tangential.is<PlainHistory>(), PlainHistory, RescaledHistory>;
    double sum = few.kinetic_energy();
    if (few.touching()) {
        const double overlap = few.met[0].overlap, radius = few.met[0].radius;
        const auto& kept = few.history(0, 0);
        sum += HertzContact::energy(overlap, radius, few.floor->pair) +
               Shear::energy({{kept[0], kept[1], kept[2]}}, std::sqrt(radius * overlap),
                             few.floor->pair.tangential_stiffness);
    }
    return sum;
}

/// An elastic impact at 45 degrees that cannot slip: how far energy strays while it lasts, and what is left.
template <ContactModel model>
std::pair<double, double> stray_and_rest(double poisson_ratio, double steps) {
    ContactSettings settings;
    settings.friction = 1e9;
    FewSpheres<model> few;
    few.floor.emplace();
    few.floor->pair = contact_constants({1e12, poisson_ratio}, rigid, settings);
    few.spheres = {{V3{{0, 0, 1e-3}}, V3{{1, 0, -1}}, V3{}, 1e-3, 1e-5}};
    few.begin();
    const double before = energy(few), dt = ContactTimes::impact(1e-3, 1e-5, 1, few.floor->pair) / steps;
    double farthest = 0;
    do {
        few.step(dt);
        if (few.touching()) farthest = std::max(farthest, std::abs(energy(few) / before - 1));
    } while (few.touching());
    return {farthest, few.kinetic_energy() / before};
}

TEST(SphereFriction, impacts_without_slip_conserve_energy_where_history_is_rescaled) {
    for (const double poisson_ratio : {0.1, 0.3}) {
        const double stray = stray_and_rest<standard>(poisson_ratio, 4000).first;
        EXPECT_LT(stray, 2e-4);
        EXPECT_LT(stray_and_rest<standard>(poisson_ratio, 8000).first, 0.6 * stray);
        EXPECT_GT(stray_and_rest<plain>(poisson_ratio, 4000).first, 0.01);
    }
    // What the spring still holds when the surfaces part is lost; nothing is gained.
    EXPECT_NEAR(stray_and_rest<standard>(0.1, 4000).second, 1.0000, 5e-4);
    EXPECT_NEAR(stray_and_rest<standard>(0.3, 4000).second, 0.9741, 5e-4);
    EXPECT_NEAR(stray_and_rest<plain>(0.1, 4000).second, 1.0151, 5e-4);
}

}  // namespace
}  // namespace dmp::tests::solver_sphere_friction_tests
