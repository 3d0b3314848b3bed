// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Liquid around solids of cells in 3-D that cut the lattice.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::liquid_beside_cells_tests {
namespace {

/// A ball of 1 m in a box of 2.5 m, 0.25 m between particles, periodic along all axes.
const Texts ball{R"(schema = 1
dimension = 3
[geometry]
file = "channel.geo"
parameters = { x = "1.25 m", y = "1.25 m", z = "1.25 m" }
[particles]
spacing = "0.25 m"
[[part]]
name = "water"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 Pa*s"
[[part]]
name = "ball"
kind = "elastic"
density = "1100 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
[flow]
periodic = ["x", "y", "z"]
largest_speed = "0.1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
fields = []
)",
                 R"(SetFactory("OpenCASCADE");
DefineConstant[ x = {1.25, Name "x"}, y = {1.25, Name "y"}, z = {1.25, Name "z"} ];
Mesh.MeshSizeMax = 0.1;
Box(1) = {0, 0, 0, 2.5, 2.5, 2.5};
Sphere(2) = {x, y, z, 0.5};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; };
Physical Volume("water") = {3};
Physical Volume("ball") = {2};
)"};

Texts at(const std::string& x, const std::string& y, const std::string& z) {
    return ball.with("parameters = { x = \"1.25 m\", y = \"1.25 m\", z = \"1.25 m\" }",
                     "parameters = { x = \"" + x + " m\", y = \"" + y + " m\", z = \"" + z + " m\" }");
}

double volume_of(const ParticleSet& set, PartKind kind) {
    double volume = 0;
    for (std::size_t i = 0; i < set.size(); ++i) volume += set.kind(i) == kind ? set.volume[i] : 0;
    return volume;
}

/// From a liquid particle to one of the solid [spacings].
double nearest_to_solid(const ParticleSet& set) {
    double nearest = 1;
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < set.size() && set.kind(i) == PartKind::fluid; ++j)
            if (set.kind(j) == PartKind::elastic)
                nearest = std::min(nearest, nearest_image(set.position[i] - set.position[j], set).norm() / set.spacing);
    return nearest;
}

TEST(LiquidBesideCellsInSpace, has_the_drawn_volume_wherever_the_ball_is) {
    for (const Texts& texts : {at("1.25", "1.25", "1.25"), at("1.3", "1.2", "1.17"), at("0.6", "1.31", "1.88")}) {
        const Meshed meshed = mesh_texts(texts);
        const ParticleSet& set = meshed.particles;
        const double drawn = meshed.geometry.solid("water")->volume();
        EXPECT_NEAR(volume_of(set, PartKind::fluid) / drawn, 1, 3e-4);
        EXPECT_NEAR(volume_of(set, PartKind::fluid) + volume_of(set, PartKind::elastic), 2.5 * 2.5 * 2.5, 3e-3);
        EXPECT_GE(nearest_to_solid(set), 0.7 - 1e-9);
        // As many particles as there is room for: equal shares are those of the lattice.
        for (std::size_t i = 0; i < set.size(); ++i)
            if (set.kind(i) == PartKind::fluid) {
                EXPECT_NEAR(set.volume[i] / (0.25 * 0.25 * 0.25), 1, 1e-3);
                EXPECT_NEAR(set.mass[i] / set.volume[i], 1000, 1e-9);
            }
        EXPECT_NEAR(meshed.report.parts[1].reached, meshed.report.parts[1].target, 3e-4 * drawn);
    }
}

TEST(LiquidBesideCellsInSpace, is_the_same_where_the_liquid_is_drawn_through_the_ball) {
    Texts through = ball;
    through.cad_geometry = R"(SetFactory("OpenCASCADE");
DefineConstant[ x = {1.25, Name "x"}, y = {1.25, Name "y"}, z = {1.25, Name "z"} ];
Mesh.MeshSizeMax = 0.1;
Box(1) = {0, 0, 0, 2.5, 2.5, 2.5};
Sphere(2) = {x, y, z, 0.5};
Physical Volume("water") = {1};
Physical Volume("ball") = {2};
)";
    const Meshed around = mesh_texts(ball), one_in_the_other = mesh_texts(through);
    EXPECT_EQ(around.particles.count(PartKind::fluid), one_in_the_other.particles.count(PartKind::fluid));
    EXPECT_NEAR(volume_of(around.particles, PartKind::fluid), volume_of(one_in_the_other.particles, PartKind::fluid),
                1e-3);
}

TEST(LiquidBesideCellsInSpace, of_two_liquids_goes_to_the_one_that_is_there) {
    Texts two = ball;
    two.scene += "[[part]]\nname = \"oil\"\nkind = \"fluid\"\ndensity = \"900 kg/m^3\"\nviscosity = \"1 Pa*s\"\n";
    two.cad_geometry = R"(SetFactory("OpenCASCADE");
DefineConstant[ x = {1.25, Name "x"}, y = {1.25, Name "y"}, z = {1.25, Name "z"} ];
Mesh.MeshSizeMax = 0.1;
Box(1) = {0, 0, 0, 2.5, 2.5, 1.25};
Box(2) = {0, 0, 1.25, 2.5, 2.5, 1.25};
Sphere(3) = {1.28, 1.2, 1.3, 0.5};
BooleanFragments{ Volume{1, 2}; Delete; }{ Volume{3}; Delete; }
ball() = Volume In BoundingBox {0.7, 0.6, 0.7, 1.9, 1.8, 1.9};
low() = Volume In BoundingBox {-0.1, -0.1, -0.1, 2.6, 2.6, 1.3};
low() -= ball();
high() = Volume In BoundingBox {-0.1, -0.1, 1.2, 2.6, 2.6, 2.6};
high() -= ball();
Physical Volume("water") = low();
Physical Volume("oil") = high();
Physical Volume("ball") = ball();
)";
    const Meshed meshed = mesh_texts(two);
    const ParticleSet& set = meshed.particles;
    for (const std::string name : {"water", "oil"}) {
        double volume = 0;
        for (std::size_t i = 0; i < set.size(); ++i) volume += set.part[i] == set.part_named(name) ? set.volume[i] : 0;
        EXPECT_NEAR(volume / meshed.geometry.solid(name)->volume(), 1, 3e-4) << name;
    }
    EXPECT_NEAR(volume_of(set, PartKind::fluid) + volume_of(set, PartKind::elastic), 2.5 * 2.5 * 2.5, 3e-3);
}

TEST(LiquidBesideCellsInSpace, has_its_volume_beside_a_block_on_a_wall) {
    Texts standing = ball.with("periodic = [\"x\", \"y\", \"z\"]", "periodic = [\"x\", \"y\"]");
    standing.scene += "[[part]]\nname = \"wall\"\nkind = \"rigid\"\n";
    standing.cad_geometry = R"(SetFactory("OpenCASCADE");
DefineConstant[ x = {1.25, Name "x"}, y = {1.25, Name "y"}, z = {1.25, Name "z"} ];
Box(1) = {0, 0, 0, 2.5, 2.5, 2.5};
Box(2) = {0.83, 0.57, 0, 0.8, 0.9, 1.1};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; };
Physical Volume("water") = {3};
Physical Volume("ball") = {2};
foot() = Surface In BoundingBox {0.8, 0.5, -0.01, 1.7, 1.5, 0.01};
floor() = Surface In BoundingBox {-0.1, -0.1, -0.01, 2.6, 2.6, 0.01};
roof() = Surface In BoundingBox {-0.1, -0.1, 2.49, 2.6, 2.6, 2.51};
Physical Surface("wall") = {floor(), roof()};
)";
    const Meshed meshed = mesh_texts(standing);
    EXPECT_NEAR(volume_of(meshed.particles, PartKind::fluid) / meshed.geometry.solid("water")->volume(), 1, 1e-3);
}

}  // namespace
}  // namespace dmp::tests::liquid_beside_cells_tests
