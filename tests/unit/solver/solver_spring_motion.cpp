// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/ladder_body.hpp"

namespace dmp::tests::solver_spring_motion_tests {
namespace {

enum class Stepping { subcycled, implicit };

/// A body on its own; no fluid.
class Motion {
  public:
    Motion(const ParticleSet& set, const Part& part, Stepping stepping)
        : set_(set), body_(set, part, 0), stepping_(stepping) {}

    PlaneBody::Impulses advance(double dt) {
        const Vectors before = body_.positions();
        auto impulses = stepping_ == Stepping::subcycled ? body_.advance_subcycled(dt, 1) : body_.advance_implicit(dt);
        double kinetic = 0;
        Vectors middle = before;
        for (std::size_t n = 0; n < before.size(); ++n) {
            const V2 moved = body_.positions()[n] - before[n];
            kinetic += 0.5 * set_.mass[n] * dot(moved, moved) / (dt * dt);
            middle[n] += 0.5 * moved;
        }
        std::swap(middle, body_.positions());
        energy_ = kinetic + body_.energy();
        std::swap(middle, body_.positions());
        return impulses;
    }
    /// Kinetic and potential energy in the middle of the last step.
    [[nodiscard]] double energy() const { return energy_; }
    PlaneBody& body() { return body_; }

    /// Gives every free node of column c the force force(c) for `dt`.
    void kick(double dt, const std::function<V2(int)>& force) {
        Vectors forces;
        for (std::size_t n = 0; n < set_.size(); ++n) forces.push_back(force(static_cast<int>(n) / 2));
        body_.kick_from_outside(forces, dt);
    }

  private:
    const ParticleSet& set_;
    PlaneBody body_;
    Stepping stepping_;
    double energy_ = 0;
};

class FreeVibration : public testing::TestWithParam<Stepping> {
  protected:
    static constexpr LadderShape shape{20, 0.5, true};
    ParticleSet set = ladder(shape);

    /// 2 pi f1 of a cantilever of mass 2 m / a per length; the end column has its full mass: 1 - 1/n.
    [[nodiscard]] static double first_omega() {
        const double length = shape.cells;
        return 1.8751 * 1.8751 * std::sqrt(bending_stiffness(shape.hinge_stiffness) / (2 * std::pow(length, 4))) *
               (1 - 1.0 / shape.cells);
    }
    [[nodiscard]] double step() const {
        const double period = 2 * std::numbers::pi / first_omega();
        return GetParam() == Stepping::implicit ? period / 400 : 0.25;  // 0.25: half of the explicit limit
    }
    /// The body in the shape that a small end load gives it.
    [[nodiscard]] Motion released(double damping) const {
        Motion motion(set, part_with(damping), GetParam());
        motion.body().positions() = statics(motion.body(), set, end_load(set, {{0, 1e-8}}));
        return motion;
    }
};

TEST_P(FreeVibration, first_frequency_is_the_cantilevers) {
    const PlaneBody still(set, part_with(0), 0);
    Motion motion = released(0);
    const Vectors first_shape = motion.body().positions();
    const auto amplitude = [&] {  // projected on the first shape: higher modes hardly show
        double sum = 0;
        for (std::size_t n = 0; n < set.size(); ++n)
            sum += (motion.body().positions()[n][1] - still.positions()[n][1]) *
                   (first_shape[n][1] - still.positions()[n][1]);
        return sum;
    };
    const double dt = step();
    std::vector<double> crossings;
    double before = amplitude();
    for (long k = 1; crossings.size() < 9; ++k) {
        ASSERT_LT(static_cast<double>(k) * dt * first_omega(), 60);
        motion.advance(dt);
        const double now = amplitude();
        if (before * now < 0) crossings.push_back((static_cast<double>(k) - now / (now - before)) * dt);
        before = now;
    }
    const double period = (crossings.back() - crossings.front()) / 4;
    EXPECT_NEAR(2 * std::numbers::pi / period / first_omega(), 1, 5e-3);
}

TEST_P(FreeVibration, energy_without_damping_is_bounded_and_does_not_drift) {
    Motion motion = released(0);
    const double start = motion.body().energy();
    const double dt = step();
    const long steps = std::lround(12 * 2 * std::numbers::pi / first_omega() / dt);
    double early = 0, late = 0;
    for (long k = 0; k < steps; ++k) {
        motion.advance(dt);
        ASSERT_NEAR(motion.energy() / start, 1, 0.03) << "step " << k;
        (k < steps / 2 ? early : late) += motion.energy();
    }
    EXPECT_NEAR(late / early, 1, 2e-3);
}

TEST_P(FreeVibration, dashpots_take_energy) {
    Motion motion = released(0.05);
    const double start = motion.body().energy();
    const double dt = step();
    const long steps = std::lround(12 * 2 * std::numbers::pi / first_omega() / dt);
    for (long k = 0; k < steps; ++k) {
        motion.advance(dt);
        ASSERT_LT(motion.energy(), 1.01 * start);
    }
    EXPECT_LT(motion.energy(), 0.99 * start);
    EXPECT_GT(motion.energy(), 0.1 * start);  // it is a light one
}

TEST_P(FreeVibration, free_body_keeps_its_momentum) {
    const ParticleSet free_set = ladder({12, 0.5, false});
    Motion motion(free_set, part_with(0.02), GetParam());
    motion.kick(1.0, [](int column) { return V2{{1e-3 * column, 2e-3 * (column % 3)}}; });
    const V2 before = motion.body().momentum();
    ASSERT_GT(before[0], 0.1);
    for (int k = 0; k < 500; ++k) {
        const auto given = motion.advance(0.2);
        EXPECT_EQ(given.of_anchors[0], 0);
        EXPECT_EQ(given.of_drag[0], 0);
    }
    EXPECT_NEAR(motion.body().momentum()[0], before[0], 1e-13);
    EXPECT_NEAR(motion.body().momentum()[1], before[1], 1e-13);
}

TEST_P(FreeVibration, free_body_flies_on_and_turns_without_strain_being_braked) {
    // Uniform kick: all move alike, nothing is stretched, dashpots are silent.
    const ParticleSet free_set = ladder({6, 0.5, false});
    Motion motion(free_set, part_with(0.1), GetParam());
    motion.kick(1.0, [](int) { return V2{{0.3, -0.1}}; });
    for (int k = 0; k < 100; ++k) motion.advance(0.2);
    for (std::size_t n = 0; n < free_set.size(); ++n) {
        EXPECT_NEAR(motion.body().positions()[n][0] - free_set.position[n][0], 6.0, 1e-9);
        EXPECT_NEAR(motion.body().positions()[n][1] - free_set.position[n][1], -2.0, 1e-9);
    }
}

TEST_P(FreeVibration, momentum_changes_by_what_anchors_and_drag_give) {
    Motion motion(set, part_with(0.01, 0.003), GetParam());
    motion.kick(1.0, [](int column) { return V2{{0, 1e-5 * column}}; });
    const V2 before = motion.body().momentum();
    V2 given = V2::zero();
    for (int k = 0; k < 400; ++k) {
        const auto impulses = motion.advance(0.2);
        given += impulses.of_anchors;
        given += impulses.of_drag;
    }
    const V2 change = motion.body().momentum() - before;
    ASSERT_GT(std::abs(change[1]), 1e-5);
    EXPECT_NEAR(change[0], given[0], 1e-14);
    EXPECT_NEAR(change[1], given[1], 1e-14);
}

TEST_P(FreeVibration, anchored_nodes_stay) {
    Motion motion(set, part_with(0.01), GetParam());
    motion.kick(1.0, [](int column) { return V2{{0, 1e-4 * column}}; });
    motion.advance(0.2);
    for (std::size_t n = 0; n < set.size(); ++n) {
        const V2& before = motion.body().positions_before()[n];
        const V2 moved = motion.body().positions()[n] - before, mean = motion.body().mean_velocity(n, 0.2);
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_EQ(before[axis], set.position[n][axis]);
            EXPECT_NEAR(mean[axis], moved[axis] / 0.2, 1e-15);
            EXPECT_TRUE(!set.fixed[n] || moved[axis] == 0);
        }
    }
    EXPECT_GT(motion.body().mean_velocity(set.size() - 1, 0.2)[1], 0);
}

INSTANTIATE_TEST_SUITE_P(Stepping, FreeVibration, testing::Values(Stepping::subcycled, Stepping::implicit),
                         [](const auto& stepping) {
                             return stepping.param == Stepping::subcycled ? "subcycled" : "implicit";
                         });

TEST(SpringBody, implicit_steps_are_stable_far_beyond_the_explicit_limit) {
    const ParticleSet set = ladder({16, 0.5, true});
    PlaneBody body(set, part_with(0.01), 0);
    for (std::size_t n = 2; n < set.size(); ++n) body.positions()[n][1] += n % 3 == 0 ? 0.002 : -0.002;
    const double before = body.energy(), dt = 40 * body.step_limit();
    for (int step = 0; step < 300; ++step) {
        body.advance_implicit(dt);
        ASSERT_LT(body.energy(), 1.5 * before);
    }
}

TEST(SpringBody, both_ways_to_step_give_the_same_large_motion) {
    // A cantilever hit so hard that its tip swings by a third of its length.
    const ParticleSet set = ladder({10, 0.5, true});
    Motion fine(set, part_with(0.02), Stepping::subcycled), coarse(set, part_with(0.02), Stepping::implicit);
    for (Motion* motion : {&fine, &coarse}) motion->kick(1.0, [](int column) { return V2{{0, 1.2e-2 * column}}; });
    double swing = 0;
    for (int k = 0; k < 300; ++k) {
        for (int small = 0; small < 10; ++small) fine.advance(0.01);
        coarse.advance(0.1);
        const V2 difference = fine.body().positions().back() - coarse.body().positions().back();
        EXPECT_LT(std::sqrt(dot(difference, difference)), 0.02) << "at t = " << 0.1 * (k + 1);
        swing = std::max(swing, std::abs(fine.body().positions().back()[1] + 0.5));
    }
    EXPECT_GT(swing, 2);
}

}  // namespace
}  // namespace dmp::tests::solver_spring_motion_tests
