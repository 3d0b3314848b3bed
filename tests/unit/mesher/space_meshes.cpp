// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Geometries in 3-D.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::space_meshes_tests {
namespace {

/// A duct of 2 m x 1 m x 1 m along x between walls, periodic along x.
const Texts duct{R"(schema = 1
dimension = 3
[geometry]
file = "channel.geo"
[particles]
spacing = "0.125 m"
[[part]]
name = "water"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 mPa*s"
[[part]]
name = "wall"
kind = "rigid"
[flow]
periodic = ["x"]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
                 R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1, 1};
Physical Volume("water") = {1};
Physical Surface("wall") = {3, 4, 5, 6};
)"};

/// A ball in the middle of a box whose sides are all periodic; drawn over the fluid, not cut out of it.
const Texts ball{duct.scene, R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1, 1};
Sphere(2) = {1, 0.5, 0.5, 0.4};
Physical Volume("water") = {1};
Physical Volume("wall") = {2};
)"};

TEST(SpaceMeshes, a_duct_is_filled_and_walled) {
    const auto meshed = mesh_texts(duct);
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(set.dimension, 3);
    EXPECT_EQ(set.count(PartKind::fluid), 16U * 8 * 8);
    // The outermost of each corner are more than three spacings from the surface.
    EXPECT_EQ(set.count(PartKind::rigid), 16U * (14 * 14 - 4 - 8 * 8));
    for (std::size_t i = 0; i < set.size(); ++i) {
        EXPECT_EQ(set.volume[i], std::pow(0.125, 3));
        EXPECT_EQ(set.mass[i], 1000 * std::pow(0.125, 3));
        if (set.kind(i) == PartKind::fluid) continue;
        EXPECT_EQ(set.fixed[i], 1);
        EXPECT_NEAR(set.wall_normal[i].norm(), 1, 1e-14);
        const Vec on_surface = set.position[i] + set.wall_distance[i] * set.wall_normal[i];
        EXPECT_NEAR(std::max(std::abs(on_surface.y() - 0.5), std::abs(on_surface.z() - 0.5)), 0.5, 1e-12);
        EXPECT_GT(set.wall_distance[i], 0.06);
    }
    EXPECT_EQ(set.box.extent().x(), 2);
    const auto& water = meshed.report.parts.front();
    EXPECT_EQ(water.unit, "m^3");
    EXPECT_NEAR(water.target, 2, 1e-12);
    EXPECT_NEAR(water.reached, 2, 1e-12);
    EXPECT_NEAR(water.nearest, 1, 1e-12);
    // The walls complete the kernel of all fluid.
    EXPECT_NEAR(water.kernel_sum_mean, 1.00314, 1e-5);  // the whole lattice's
    EXPECT_LT(water.kernel_sum_spread, 1e-6);
}

TEST(SpaceMeshes, a_body_that_overlaps_the_fluid_takes_its_room) {
    const auto meshed = mesh_texts(ball.with("periodic = [\"x\"]", "periodic = [\"x\", \"y\", \"z\"]")
                                       .with("spacing = \"0.125 m\"", "spacing = \"0.05 m\""));
    const ParticleSet& set = meshed.particles;
    const double volume = 4.0 / 3 * std::numbers::pi * std::pow(0.4, 3);
    EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)) * std::pow(0.05, 3), 2 - volume, 0.01);
    std::size_t shell = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec from_centre = set.position[i] - Vec(1, 0.5, 0.5);
        if (set.kind(i) == PartKind::fluid) {
            EXPECT_GT(from_centre.norm(), 0.4 - 1e-3);
            continue;
        }
        ++shell;
        EXPECT_LT(from_centre.norm(), 0.4);
        EXPECT_NEAR(set.wall_distance[i], 0.4 - from_centre.norm(), 2e-3);
        EXPECT_LT(set.wall_distance[i], 3 * 0.05);
        EXPECT_GT(set.wall_normal[i].dot(from_centre.normalized()), 0.98);
    }
    const double hollow = 4.0 / 3 * std::numbers::pi * std::pow(0.25, 3);
    EXPECT_NEAR(static_cast<double>(shell) * std::pow(0.05, 3), volume - hollow, 0.01);
}

TEST(SpaceMeshes, a_body_with_holes_is_filled_all_the_same) {
    const auto meshed = mesh_texts(ball.with("periodic = [\"x\"]", "periodic = [\"x\", \"y\", \"z\"]"));
    Geometry torn = meshed.geometry;
    for (Solid& solid : torn.solids) {
        if (solid.name != "wall") continue;
        std::size_t number = 0;
        std::erase_if(solid.surface.triangles, [&](const auto&) { return number++ % 10 == 0; });
        solid.surface.has_holes = true;
    }
    const MeshResult torn_mesh = mesh(torn, meshed.scene);
    for (const PartKind kind : {PartKind::fluid, PartKind::rigid}) {
        const auto whole = static_cast<double>(meshed.particles.count(kind));
        EXPECT_NEAR(static_cast<double>(torn_mesh.particles.count(kind)), whole, 0.02 * whole);
    }
}

TEST(SpaceMeshes, say_what_is_too_thin_for_particles) {
    const auto warnings = [](const Texts& texts) { return mesh_texts(texts).report.warnings; };
    EXPECT_THAT(warnings(duct), ::testing::IsEmpty());
    EXPECT_THAT(warnings(duct.with("Box(1) = {0, 0, 0, 2, 1, 1}", "Box(1) = {0, 0, 0, 2, 0.25, 1}")),
                ::testing::ElementsAre(::testing::HasSubstr("water: a gap of 2 spacings near (")));
    const Texts around = ball.with("periodic = [\"x\"]", "periodic = [\"x\", \"y\", \"z\"]");
    EXPECT_THAT(warnings(around.with("Sphere(2) = {1, 0.5, 0.5, 0.4}", "Box(2) = {0.5, 0.3, 0.3, 0.2, 0.4, 0.4}")),
                ::testing::Contains(
                    ::testing::AllOf(::testing::HasSubstr("wall: a thickness of 1.6 spacings near (600, "),
                                     ::testing::HasSubstr(" mm, less than 2 particles, as are 50 % of its surface"))));
    EXPECT_THAT(warnings(around
                             .with("Sphere(2) = {1, 0.5, 0.5, 0.4}",
                                   "Box(2) = {0.2, 0.2, 0.2, 0.4, 0.6, 0.6};\nBox(3) = {0.85, 0.2, 0.2, 0.4, 0.6, 0.6}")
                             .with("\"wall\") = {2}", "\"wall\") = {2, 3}")),
                ::testing::Contains(::testing::HasSubstr("water: a gap of 2 spacings near (725, ")));
}

TEST(SpaceMeshes, arrangements_have_equally_many_particles) {
    const auto count = [](const char* arrangement) {
        const auto meshed = mesh_texts(duct.with(
            "spacing = \"0.125 m\"", std::string("spacing = \"0.05 m\"\narrangement = \"") + arrangement + "\""));
        return static_cast<double>(meshed.particles.count(PartKind::fluid)) * meshed.particles.volume[0];
    };
    EXPECT_NEAR(count("square"), 2, 1e-9);
    EXPECT_NEAR(count("fcc"), 2, 0.1);
    EXPECT_NEAR(count("hexagonal"), 2, 0.1);
}

TEST(SpaceMeshes, what_is_open_is_named) {
    EXPECT_EQ(fault_of(duct), "no error");
    // The surface is two triangles of one area.
    EXPECT_THAT(fault_of(duct.with("{3, 4, 5, 6}", "{3, 4, 5}")),
                testing::MatchesRegex("scene.toml:8:8: the boundary of 'water' is open over 2e.06 mm.2, near .*, 1. "
                                      "m: no rigid part and no periodic side closes it\n  name this surface in the "
                                      "geometry as part of a rigid part, or make the axis periodic .flow.periodic., or "
                                      "the side a plane of symmetry .flow.symmetry."));
    EXPECT_THAT(fault_of(duct.with("periodic = [\"x\"]\n", "")), testing::HasSubstr("is open over 2e+06 mm^2"));
    EXPECT_EQ(fault_of(duct.with("periodic = [\"x\"]", "periodic = [\"x\"]\nsymmetry = [\"z_high\"]")
                           .with("{3, 4, 5, 6}", "{3, 4, 5}")),
              "no error");
}

TEST(SpaceMeshes, wrong_dimensions_and_kinds) {
    EXPECT_EQ(
        fault_of(duct.with("dimension = 3", "dimension = 2")),
        "scene.toml:2:13: the geometry has volumes, and the scene has 2 dimensions (channel.geo)\n  write dimension "
        "= 3, or name another geometry");
    EXPECT_EQ(fault_of(channel.with("schema = 1", "schema = 1\ndimension = 3")),
              "scene.toml:2:13: the geometry lies in 2-D, and the scene has 3 dimensions (channel.geo)\n  write "
              "dimension = 2, or name another geometry");
    EXPECT_EQ(fault_of(duct.with("name = \"water\"", "name = \"wall\"")
                           .with("name = \"wall\"\nkind = \"rigid\"", "name = \"water\"\nkind = \"rigid\"")),
              "scene.toml:8:8: 'wall' is a surface in the geometry, but a volume for a fluid is needed here "
              "(channel.geo)\n  it names 'wall' and 'water'");
    EXPECT_THAT(fault_of(duct.with("spacing = \"0.125 m\"", "spacing = \"0.125 m\"\ndisorder = 0.1")),
                testing::HasSubstr("particles.disorder: lattices in 3-D cannot be disturbed yet"));
    EXPECT_THAT(fault_of(channel.with("spacing = \"0.125 m\"", "spacing = \"0.125 m\"\narrangement = \"fcc\"")),
                testing::HasSubstr("\"fcc\" is a lattice in 3-D"));
    EXPECT_THAT(fault_of(channel.with("periodic = [\"x\"]", "periodic = [\"x\"]\nsymmetry = [\"z_low\"]")),
                testing::HasSubstr("a scene in 2-D has no side 'z_low'"));
}

}  // namespace
}  // namespace dmp::tests::space_meshes_tests
