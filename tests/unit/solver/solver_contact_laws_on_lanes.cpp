// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "models/dem/contact_law.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_contact_laws_on_lanes_tests {
namespace {

using Wide = Vector<Lanes, 3>;
using V3 = Vector<double, 3>;

ContactConstants<> all_at_once() {
    ContactConstants<> pair;
    pair.normal_stiffness = 3e9;
    pair.tangential_stiffness = 2.5e9;
    pair.normal_dashpot = 3e4;
    pair.tangential_dashpot = 2e4;
    pair.normal_rate = 1e12;
    pair.tangential_rate = 3e12;
    pair.least_normal = 0;
    pair.friction = 0.4;
    pair.rolling_friction = 0.1;
    pair.rolling_damping = 0.2;
    pair.adhesion_energy = 0.02;
    pair.adhesion_distance = 4e-10;
    pair.adhesion_range = 2e-8;
    return pair;
}

/// Contacts and gaps side by side, and one by one: spheres of some um, followed for some steps.
template <ContactModel model>
void expect_the_same() {
    using Law = ContactLaw<model>;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1, 1), unit(0, 1);
    const ContactConstants<> pair = all_at_once();
    int touching = 0, apart = 0;
    for (int turn = 0; turn < 50; ++turn) {
        SpherePoint<Lanes> wide_i, wide_j;
        Wide separation;
        std::array<SpherePoint<double>, Lanes::width> i, j;
        std::array<V3, Lanes::width> x;
        const auto put = [](Wide& wide, std::size_t k, const V3& v) {
            for (int axis = 0; axis < 3; ++axis) wide[axis].set(k, v[axis]);
        };
        const auto vector = [&](double size) {
            return V3{{size * any(random), size * any(random), size * any(random)}};
        };
        for (std::size_t k = 0; k < Lanes::width; ++k) {
            const auto sphere = [&] {
                const double radius = (1 + unit(random)) * 1e-6;
                return SpherePoint<double>{vector(1), vector(1e5), radius, 4e3 * radius * radius * radius};
            };
            i[k] = sphere();
            j[k] = sphere();
            const V3 direction = vector(1);
            const double gap = any(random) * 5e-9, distance = i[k].radius + j[k].radius + gap;
            x[k] = (distance / std::sqrt(dot(direction, direction))) * direction;
            for (const auto& [wide, one] : {std::pair{&wide_i, &i[k]}, {&wide_j, &j[k]}}) {
                put(wide->velocity, k, one->velocity);
                put(wide->spin, k, one->spin);
                wide->radius.set(k, one->radius);
                wide->mass.set(k, one->mass);
            }
            put(separation, k, x[k]);
        }
        typename Law::template History<Lanes> wide_history;
        for (Lanes& value : wide_history) value = Lanes(0.0);
        std::array<typename Law::template History<double>, Lanes::width> history{};
        for (int step = 0; step < 4; ++step) {
            const Lanes distance = sqrt(dot(separation, separation));
            const auto wide = contact_of_spheres<Law>(wide_i, wide_j, separation, distance);
            const auto wide_force = Law::law(wide, pair, wide_history, 1e-10);
            for (std::size_t k = 0; k < Lanes::width; ++k) {
                const auto one = contact_of_spheres<Law>(i[k], j[k], x[k], std::sqrt(dot(x[k], x[k])));
                const auto force = Law::law(one, pair, history[k], 1e-10);
                (one.overlap > 0 ? touching : apart) += 1;
                const double small =
                    1e-9 * (std::abs(force.normal) + std::sqrt(dot(force.tangential, force.tangential)));
                EXPECT_NEAR(wide_force.normal[k], force.normal, small);
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_NEAR(wide_force.tangential[axis][k], force.tangential[axis], small);
                    EXPECT_NEAR(wide_force.rolling[axis][k], force.rolling[axis], 1e-6 * small);
                }
                for (std::size_t value = 0; value < history[k].size(); ++value) {
                    EXPECT_NEAR(wide_history[value][k], history[k][value], 1e-9 * std::abs(history[k][value]) + 1e-18);
                    if (one.overlap < 0 && !model.normal.is<JkrContact>()) {
                        EXPECT_EQ(history[k][value], 0);
                    }
                }
                if (!model.is_adhesive() && one.overlap < 0) {
                    EXPECT_EQ(force.normal, 0);
                }
                if (one.overlap < 0 && !model.normal.is<JkrContact>()) {
                    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(force.tangential[axis], 0);
                }
            }
        }
    }
    EXPECT_GT(touching, 50);
    EXPECT_GT(apart, 50);
}

TEST(ContactLawsOnLanes, give_what_they_give_on_numbers) {
    expect_the_same<model_of<>>();
    expect_the_same<model_of<HertzContact, PlainHistory, NoRolling, NoAdhesion>>();
    expect_the_same<model_of<HertzContact, RescaledHistory, ConstantRolling, BradleyAdhesion>>();
    expect_the_same<model_of<HertzContact, RescaledHistory, RollingSpring, NoAdhesion>>();
    expect_the_same<model_of<JkrContact, RescaledHistory, RollingSpring, NoAdhesion>>();
    expect_the_same<model_of<HertzContact, RescaledHistory, NoRolling, DmtAdhesion>>();
    expect_the_same<model_of<JkrContact, PlainHistory, NoRolling, NoAdhesion>>();
}

// i and j change their parts: forces are opposite, and so is what is remembered of directions.
TEST(ContactLawsOnLanes, do_not_care_which_sphere_is_first) {
    using Law = ContactLaw<model_of<JkrContact, RescaledHistory, RollingSpring, NoAdhesion>>;
    const ContactConstants<> pair = all_at_once();
    const SpherePoint<double> i{{{0.1, -0.3, 0.2}}, {{1e4, 2e4, -3e4}}, 1e-6, 4e-15};
    const SpherePoint<double> j{{{-0.2, 0.1, 0.3}}, {{-1e4, 5e4, 2e4}}, 2e-6, 3e-14};
    const V3 x{{2.998e-6, 0, 0}};
    Law::History<double> ij{}, ji{};
    for (int step = 0; step < 3; ++step) {
        const auto one = Law::law(contact_of_spheres<Law>(i, j, x, 2.998e-6), pair, ij, 1e-10);
        const auto other = Law::law(contact_of_spheres<Law>(j, i, -1.0 * x, 2.998e-6), pair, ji, 1e-10);
        EXPECT_NEAR(one.normal, other.normal, 1e-13 * std::abs(one.normal));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(one.tangential[axis], -other.tangential[axis], 1e-12 * std::abs(one.normal));
            EXPECT_NEAR(one.rolling[axis], -other.rolling[axis], 1e-18 * std::abs(one.normal));
        }
        for (std::size_t value = 0; value < 6; ++value)
            EXPECT_NEAR(ij[value], -ji[value], 1e-12 * std::abs(ij[value]) + 1e-20);
        EXPECT_GT(ij[6], 0);
        EXPECT_NEAR(ij[6], ji[6], 1e-12 * ij[6]);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_contact_laws_on_lanes_tests
