// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of elastic bodies: how the deformation carries them, and liquid that flows past them without slip.
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "models/elastic/carried_surface.hpp"
#include "tests/modules.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::solver_body_surfaces_tests {
namespace {

TEST(CarriedSurface, turns_and_thins_with_the_solid) {
    // Stretched to three halves along x, to half along y, sheared by 0.2, then turned by 0.7.
    Eigen::Matrix2d stretch;
    stretch << 1.5, 0.2, 0, 0.5;
    const Eigen::Matrix2d f = Eigen::Rotation2Dd(0.7) * stretch;
    const auto surface = models::CarriedSurface<2>::of({0, 1}, f.inverse());
    // The material line along x stays one, turned; the plane below it comes as much nearer as y is pressed.
    EXPECT_NEAR((surface.normal - Eigen::Vector2d(-std::sin(0.7), std::cos(0.7))).norm(), 0, 1e-14);
    EXPECT_NEAR(surface.stretch, 0.5, 1e-14);
    EXPECT_EQ(models::CarriedSurface<2>::of({0, 0}, f.inverse()).normal.norm(), 0);
}

TEST(MotionAround, is_exact_for_uniform_motions_and_knows_where_arms_span_no_space) {
    Eigen::Matrix3d f, l;
    f << 1.1, 0.2, 0, -0.1, 0.9, 0.3, 0, 0.1, 1;
    l << 0.3, -2, 1, 0.5, 0.1, 0, 0, 4, -0.2;
    models::MotionAround<3> around;
    EXPECT_FALSE(around.spans_space());
    const std::array<Eigen::Vector3d, 4> arms{Eigen::Vector3d(1, 0, 0), {0, 1, 0.5}, {0.2, 0, 1}, {-1, 0.3, 0}};
    for (const Eigen::Vector3d& arm : arms) around.add(arm, f * arm, l * (f * arm));
    EXPECT_TRUE(around.spans_space());
    EXPECT_NEAR((around.to_rest() - f.inverse()).norm(), 0, 1e-12);
    EXPECT_NEAR((around.velocity_gradient() - l).norm(), 0, 1e-12);
    models::MotionAround<3> of_thread;
    for (const double way : {-1.0, 1.0}) of_thread.add({way, 0, 0}, {way, 0, 0}, {0, way, 0});
    EXPECT_FALSE(of_thread.spans_space());
}

/// Flux between elastic layers over that of Poiseuille's flow, less 1, where it is steady.
double error_between_layers(const std::vector<std::string>& overrides) {
    std::vector<std::string> all{"particles.spacing=1 mm"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    const RunSummary run = run_case("verification/elastic_walls", all, 5, nullptr, 1);
    return run.measures.rows.back().at(0) / 1e-4 - 1;
}

TEST(BodySurfaces, hold_liquid_where_they_are_drawn) {
    // Rigid walls: 1.0 %; with the velocity of the body's own particles 38 %.
    EXPECT_NEAR(error_between_layers({}), 0.0098, 2e-3);
    EXPECT_NEAR(error_between_layers({"part.layers.model=springs"}), 0.0098, 2e-3);
    EXPECT_NEAR(error_between_layers({"numerics.viscosity_stepping=implicit"}), 0.0098, 2e-3);
}

}  // namespace
}  // namespace dmp::tests::solver_body_surfaces_tests
