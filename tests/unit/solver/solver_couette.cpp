// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"
#include "walled_water.hpp"

namespace dmp::tests::solver_couette_tests {
namespace {

constexpr double width = 1e-3, length = 4e-4, viscosity = 1e-6, density = 1000, lid_speed = 1.25e-5;

/// Start-up from rest between a plate at y = 0 and one at y = width that slides at 1 (series of Morris, Fox & Zhu
/// 1997); `t` in widths^2 over the kinematic viscosity, y in widths.
double speed_by_series(double y, double t) {
    constexpr double pi = std::numbers::pi;
    double u = y;
    for (int n = 1; n < 120; ++n)
        u += (n % 2 == 0 ? 2 : -2) / (n * pi) * std::sin(n * pi * y) * std::exp(-n * n * pi * pi * t);
    return u;
}

TEST(CouetteSeries, agrees_with_the_tabulated_values) {
    const std::map<double, std::array<double, 3>> tabulated{{0.01, {0.00000, 0.00041, 0.07710}},
                                                            {0.05, {0.01763, 0.11384, 0.42920}},
                                                            {0.1, {0.08834, 0.26276, 0.57606}},
                                                            {0.2, {0.18759, 0.41157, 0.68735}},
                                                            {0.5, {0.24676, 0.49542, 0.74676}}};
    for (const auto& [time, u] : tabulated)
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(speed_by_series(0.25 * (k + 1), time), u[k], 1e-5);
}

struct Flow {
    std::map<double, double> error;  ///< L2 error of the velocity by time [relative]
    RunSummary summary;
    KeptFrames kept;
};

SceneAndParticles couette(const std::string& spacing, std::vector<std::string> more = {}) {
    more.push_back("particles.spacing=\"" + spacing + "\"");
    return case_of("verification/couette", more);
}

Flow flow_of(const SceneAndParticles& made) {
    Flow flow;
    RunOptions options;
    options.sink = &flow.kept;
    Simulation simulation(made.scene, made.particles, 1);
    flow.summary = simulation.run(options);
    for (const Frame& frame : flow.kept.frames) {
        const FrameGroup& fluid = *group_of(frame, "fluid");
        const FrameField& velocity = *field_of(fluid, "velocity");
        double square = 0, reference = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double y = fluid.position[3 * k + 1] / width;
            const double expected = lid_speed * speed_by_series(y, frame.time * viscosity / (width * width));
            square += std::pow(velocity.values[3 * k] - expected, 2) + std::pow(velocity.values[3 * k + 1], 2);
            reference += expected * expected;
        }
        if (frame.time > 0) flow.error[std::round(frame.time * 1e6) / 1e6] = std::sqrt(square / reference);
    }
    return flow;
}

TEST(Couette, follows_the_series_at_20_particles_across) {
    const Flow flow = flow_of(couette("0.05 mm"));
    EXPECT_LE(flow.error.at(0.1), 0.01);
    EXPECT_LE(flow.error.at(1.0), 0.01);
    EXPECT_EQ(flow.summary.start.mass, flow.summary.end.mass);
    EXPECT_EQ(flow.summary.lost, 0U);
    // What the lid gives and the wall does not take is what the fluid has.
    EXPECT_LT(flow.summary.momentum_residual, 1e-12);
    EXPECT_EQ(flow.summary.impulse_of_body_forces[0], 0);
    EXPECT_NEAR(flow.summary.impulse_of_fixed[0], flow.summary.end.momentum[0], 1e-12 * flow.summary.end.momentum[0]);
    EXPECT_NEAR(flow.summary.end.momentum[0], density * lid_speed / 2 * width * length,
                0.005 * density * lid_speed / 2 * width * length);
    // Sliding is no flow through the surface.
    EXPECT_GT(flow.summary.density_low, 0.999 * density);
    EXPECT_LT(flow.summary.density_high, 1.001 * density);
}

TEST(Couette, follows_the_series_at_40_particles_across) {
    const Flow flow = flow_of(couette("0.025 mm", {"output.every=\"0.1 s\""}));
    EXPECT_LE(flow.error.at(0.1), 0.005);
    EXPECT_LE(flow.error.at(1.0), 0.005);
}

TEST(Couette, lid_may_slide_by_a_formula_of_time_and_place) {
    // The same speed for all, but worked out particle by particle: the same bits.
    const auto of_place = [](const std::string& formula) {
        return couette("0.05 mm", {"run.duration=\"0.05 s\"", "part.lid.surface_velocity=[\"" + formula + "\", 0]"});
    };
    const Flow uniform = flow_of(of_place("1.25e-5 m/s * sin(t / 0.01 s)"));
    const Flow by_position = flow_of(of_place("x > 10 m ? 0 : 1.25e-5 m/s * sin(t / 0.01 s)"));
    EXPECT_EQ(uniform.summary.state_hash, by_position.summary.state_hash);
    EXPECT_NE(uniform.summary.end.momentum[0], 0);
    EXPECT_LT(uniform.summary.momentum_residual, 1e-12);
}

TEST(Couette, is_a_straight_line_in_space_too) {
    // Walls y = 0 and y = 1 of a slab that is periodic in x and z, made without a geometry.
    constexpr int rows = 10, wide = 5;
    const WalledWater plane(wide, rows, {"wall", "lid"}, [](int column, int row) {
        return column < 0 || column >= wide ? 0 : row < 0 ? 1 : row >= rows ? 2 : 0;
    });
    WalledWater made = plane;
    ParticleSet& set = made.particles;
    set = ParticleSet();
    static_cast<ParticleSpace&>(set) = static_cast<const ParticleSpace&>(plane.particles);
    set.dimension = 3;
    made.scene.dimension = 3;
    set.box.high[2] = wide * spacing;
    made.make_periodic(0);
    made.make_periodic(2);
    for (int layer = 0; layer < wide; ++layer)
        for (std::size_t i = 0; i < plane.particles.size(); ++i) {
            made.add(plane.particles.part[i], plane.particles.position[i] + Vec(0, 0, (layer + 0.5) * 0.1),
                     plane.particles.wall_normal[i], plane.particles.wall_distance[i]);
            set.volume.back() *= spacing;
        }
    made.part(2).surface_velocity = std::array{formula_of("1"), Expression(), formula_of("0.5")};
    made.scene.parts[0].viscosity = 1000.0;
    KeptFrames kept;
    const RunSummary summary = run_of(made, &kept);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
    ASSERT_EQ(fluid.size(), static_cast<std::size_t>(wide * wide * rows));
    const FrameField& velocity = *field_of(fluid, "velocity");
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double y = fluid.position[3 * k + 1];
        EXPECT_NEAR(velocity.values[3 * k], y, 0.015);
        EXPECT_NEAR(velocity.values[3 * k + 1], 0, 0.01);
        EXPECT_NEAR(velocity.values[3 * k + 2], 0.5 * y, 0.0075);
    }
}

TEST(Couette, explain_names_the_lid) {
    const auto [scene, particles] = couette("0.05 mm");
    bool named = false;
    for (const ModelUse& model : Simulation(scene, particles, 1).plan().models)
        named = named || (model.model == "sliding surface of 'lid'" && model.reason.find("surface_velocity at ") == 0);
    EXPECT_TRUE(named);
}

}  // namespace
}  // namespace dmp::tests::solver_couette_tests
