// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"
#include "walled_water.hpp"

namespace dmp::tests::solver_moving_walls_tests {
namespace {

constexpr double pi = std::numbers::pi;

/// A closed box that is carried along by v = sin^2(pi t / 2 s) m/s in x and half of it in y.
WalledWater carried_box() {
    WalledWater made(10, 8, {"box"}, [](int, int) { return 1; });
    made.part(1).velocity =
        std::array{formula_of("sin(pi * t / 2)^2"), formula_of("0.5 * sin(pi * t / 2)^2"), Expression()};
    made.scene.numerics.sound_speed = 40.0;  // far above: the liquid is all but rigid
    // Both move particles about within the liquid, by a few hundredths of a spacing.
    made.scene.numerics.shifting = 0.0;
    made.scene.contact.range = 0.0;
    made.scene.run.duration = 1.5;
    made.scene.output.every = 0.5;
    return made;
}

double carried_speed(double t) { return std::pow(std::sin(pi * t / 2), 2); }
double carried_path(double t) { return t / 2 - std::sin(pi * t) / (2 * pi); }

TEST(MovingWalls, carry_a_box_of_liquid_along_as_one_body) {
    const WalledWater made = carried_box();
    KeptFrames kept;
    const RunSummary summary = run_of(made, &kept);
    ASSERT_EQ(kept.frames.size(), 4U);
    for (const Frame& frame : kept.frames) {
        SCOPED_TRACE("t = " + std::to_string(frame.time));
        const double speed = carried_speed(frame.time), path = carried_path(frame.time);
        const FrameGroup& fluid = *group_of(frame, "fluid");
        const FrameField &velocity = *field_of(fluid, "velocity"), &pressure = *field_of(fluid, "pressure");
        const double acceleration = pi / 2 * std::sin(pi * frame.time);
        double slope = 0, moment = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            EXPECT_NEAR(velocity.values[3 * k], speed, 0.003);
            EXPECT_NEAR(velocity.values[3 * k + 1], speed / 2, 0.003);
            const Vec& drawn = made.particles.position[static_cast<std::size_t>(fluid.id[k])];
            EXPECT_NEAR(fluid.position[3 * k], drawn[0] + path, 0.01 * spacing);
            EXPECT_NEAR(fluid.position[3 * k + 1], drawn[1] + path / 2, 0.01 * spacing);
            slope += pressure.values[k] * (drawn[0] - 0.5);
            moment += std::pow(drawn[0] - 0.5, 2);
        }
        // The body's own inertia: dp/dx = -rho a.
        EXPECT_NEAR(slope / moment, -1000 * acceleration, 0.05 * 1000 * pi / 2);
        // Walls stand where they were drawn, and the integral farther, to the last bit of a frame's numbers.
        EXPECT_EQ(group_of(frame, "walls"), nullptr);
        const FrameGroup& walls = *group_of(frame, "moving_walls");
        EXPECT_EQ(walls.size(), 16U * 14 - 80);
        for (std::size_t k = 0; k < walls.size(); ++k)
            EXPECT_NEAR(walls.position[3 * k], made.particles.position[static_cast<std::size_t>(walls.id[k])][0] + path,
                        2e-7);
    }
    EXPECT_EQ(summary.lost, 0U);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_NEAR(summary.impulse_of_fixed[0], 800 * carried_speed(1.5), 0.01 * 800);
    EXPECT_EQ(summary.impulse_of_body_forces[0], 0);
}

TEST(MovingWalls, continue_the_pressure_of_the_accelerated_liquid) {
    // Without it the liquid at the walls would be pushed about: what the pressure in the wall is for.
    const WalledWater made = carried_box();
    const Simulation simulation(made.scene, made.particles, 1);
    bool has_acceleration = false;
    for (const std::string& field : simulation.plan().fields)
        has_acceleration = has_acceleration || field.find("wall_acceleration") != std::string::npos;
    EXPECT_TRUE(has_acceleration);
}

TEST(MovingWalls, at_rest_have_no_fields) {
    WalledWater made = carried_box();
    made.part(1).velocity = std::array<Expression, 3>{};
    for (const std::string& field : Simulation(made.scene, made.particles, 1).plan().fields)
        for (const char* name : {"drawn", "wall_acceleration", "wall_slip"})
            EXPECT_EQ(field.find(name), std::string::npos) << field;
}

/// A piston, the left side of a cylinder, comes 0.01 of the length inwards, smoothly, between t = 0 and 1. Returns by
/// how much the density has risen.
double compression_by_a_piston(int scale) {
    const int columns = 20 * scale, rows = 8 * scale;
    WalledWater made(columns, rows, {"cylinder", "piston"},
                     [=](int column, int row) { return column < 0 && row >= 0 && row < rows ? 2 : 1; });
    const std::string speed = std::to_string(0.04 * scale);
    made.part(2).velocity =
        std::array{formula_of("t < 1 ? " + speed + " * sin(pi * t)^2 : 0"), Expression(), Expression()};
    made.scene.run.duration = 1.5;
    KeptFrames kept;
    const RunSummary summary = run_of(made, &kept);
    const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
    double density = 0, pressure = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        density += field_of(fluid, "density")->values[k] / static_cast<double>(fluid.size());
        pressure += field_of(fluid, "pressure")->values[k] / static_cast<double>(fluid.size());
    }
    const double rise = density / 1000 - 1;
    EXPECT_NEAR(pressure, 1000 * 100 * rise * (1 + 3 * rise), 0.01 * 1000 * 100 * rise);
    EXPECT_EQ(summary.lost, 0U);
    EXPECT_LT(summary.momentum_residual, 1e-11);
    EXPECT_NE(group_of(kept.frames.front(), "walls"), nullptr);
    EXPECT_EQ(group_of(kept.frames.back(), "walls"), nullptr) << "what rests is written once";
    EXPECT_EQ(group_of(kept.frames.back(), "moving_walls")->size(), 3U * static_cast<std::size_t>(rows));
    return rise;
}

TEST(MovingWalls, a_piston_compresses_the_liquid) {
    // By 0.01, but for the liquid within a support radius of the walls: an error of first order in the spacing.
    const double coarse = 0.01 - compression_by_a_piston(1), fine = 0.01 - compression_by_a_piston(2);
    EXPECT_LT(std::abs(coarse), 0.08 * 0.01);
    EXPECT_LT(std::abs(fine), 0.6 * std::abs(coarse));
}

/// A round drum of radius 1 about (1.3, 1.2).
WalledWater drum(const std::string& spin) {
    const Vec centre(1.3, 1.2, 0);
    WalledWater made(0, 0, {"drum"}, [](int, int) { return 0; });
    for (int row = -15; row < 15; ++row)
        for (int column = -15; column < 15; ++column) {
            const Vec arm((column + 0.5) * spacing, (row + 0.5) * spacing, 0);
            const double r = arm.norm();
            if (r < 1)
                made.add(0, centre + arm, Vec::Zero(), 0);
            else if (r < 1 + 3 * spacing)
                made.add(1, centre + arm, -arm / r, r - 1);
        }
    made.particles.box = {centre - Vec(1.3, 1.3, 0), centre + Vec(1.3, 1.3, 0)};
    made.part(1).spin = formula_of(spin);
    made.part(1).centre = centre;
    made.scene.parts[0].viscosity = 500.0;
    return made;
}

TEST(MovingWalls, a_drum_brings_its_liquid_to_turn_as_a_solid_body) {
    for (const bool corrected : {true, false}) {
        WalledWater made = drum("1");
        if (!corrected) use_plain_scheme(made.scene);
        made.scene.run.duration = 1.2;  // exp(-3.83^2 nu t / R^2) = 1.5e-4
        KeptFrames kept;
        const RunSummary summary = run_of(made, &kept);
        const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
        const FrameField& velocity = *field_of(fluid, "velocity");
        double square = 0, reference = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double x = fluid.position[3 * k] - 1.3, y = fluid.position[3 * k + 1] - 1.2;
            square += std::pow(velocity.values[3 * k] + y, 2) + std::pow(velocity.values[3 * k + 1] - x, 2);
            reference += x * x + y * y;
        }
        EXPECT_LT(std::sqrt(square / reference), corrected ? 0.005 : 0.02);
        EXPECT_EQ(summary.lost, 0U);
        for (const int axis : {0, 1})
            EXPECT_NEAR(summary.end.momentum[axis], summary.impulse_of_fixed[axis], 1e-10 * summary.end.mass);
        const FrameGroup& walls = *group_of(kept.frames.back(), "moving_walls");
        for (std::size_t k = 0; k < walls.size(); ++k) {
            const Vec arm = made.particles.position[static_cast<std::size_t>(walls.id[k])] - Vec(1.3, 1.2, 0);
            EXPECT_NEAR(walls.position[3 * k], 1.3 + std::cos(1.2) * arm[0] - std::sin(1.2) * arm[1], 3e-7);
        }
    }
}

TEST(MovingWalls, go_on_from_a_checkpoint_with_the_same_bits) {
    WalledWater made = drum("2 + sin(5 * t)");
    made.part(1).velocity = std::array{formula_of("0.3 * cos(4 * t)"), formula_of("0.2 * t"), Expression()};
    made.scene.run.duration = 0.5;
    made.scene.output.every = 0.25;
    const auto folder = std::filesystem::path(testing::TempDir()) / "dmp_moving_walls";
    std::filesystem::remove_all(folder);
    KeptFrames kept;
    EXPECT_EQ(run_in_two_parts(made, folder).state_hash, run_of(made, &kept).state_hash);
    std::filesystem::remove_all(folder);
}

TEST(MovingWalls, cross_a_periodic_side_without_changing_the_flow) {
    // A belt of plates, endless in x, that moves along itself by more than a period, its liquid with it.
    WalledWater made(8, 6, {"plates"}, [](int column, int) { return column >= 0 && column < 8 ? 1 : 0; });
    made.make_periodic(0);
    made.part(1).velocity = std::array{formula_of("1"), Expression(), Expression()};
    made.scene.parts[0].viscosity = 1000.0;
    KeptFrames kept;
    const RunSummary summary = run_of(made, &kept);
    EXPECT_EQ(summary.lost, 0U);
    const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
    for (std::size_t k = 0; k < fluid.size(); ++k) EXPECT_NEAR(field_of(fluid, "velocity")->values[3 * k], 1, 0.01);
    const FrameGroup& walls = *group_of(kept.frames.back(), "moving_walls");
    for (std::size_t k = 0; k < walls.size(); ++k) {
        const double drawn = made.particles.position[static_cast<std::size_t>(walls.id[k])][0];
        EXPECT_NEAR(walls.position[3 * k], std::fmod(drawn + 1, 0.8), 1e-6);
    }
}

TEST(MovingWalls, their_speed_shortens_the_step) {
    // Plates move along themselves at a quarter of the sound speed, past liquid that they hardly drag along.
    const auto steps_at = [](const std::string& speed) {
        WalledWater made(8, 6, {"plates"}, [](int column, int) { return column >= 0 && column < 8 ? 1 : 0; });
        made.make_periodic(0);
        made.part(1).velocity = std::array{formula_of(speed), Expression(), Expression()};
        made.scene.parts[0].viscosity = 0.0;
        made.scene.numerics.shifting = 0.0;
        made.scene.run.duration = 1.2;
        return static_cast<double>(run_of(made).steps);
    };
    EXPECT_NEAR(steps_at("2.5") / steps_at("0.001"), 1.25, 0.06);
}

TEST(MovingWalls, of_plain_particles_carry_the_liquid_too) {
    WalledWater made = carried_box();
    made.scene.numerics.walls = WallModel::plain;
    const RunSummary summary = run_of(made);
    EXPECT_EQ(summary.lost, 0U);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_NEAR(summary.end.momentum[0], 800 * carried_speed(1.5), 0.03 * 800);
}

TEST(MovingWalls, are_told_by_explain) {
    const WalledWater made = drum("1");
    bool named = false;
    for (const ModelUse& model : Simulation(made.scene, made.particles, 1).plan().models)
        named = named || model.model == "prescribed motion of 'drum'";
    EXPECT_TRUE(named);
}

}  // namespace
}  // namespace dmp::tests::solver_moving_walls_tests
