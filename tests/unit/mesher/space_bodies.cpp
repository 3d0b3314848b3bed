// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of springs in geometries in 3-D.
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>

#include "geometry/nearest_triangle.hpp"
#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::space_bodies_tests {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// A duct of 2 m x 1 m x 1 m along x between walls, periodic along x, and a column on its floor, drawn over the fluid.
const Texts column{R"(schema = 1
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
[[part]]
name = "body"
kind = "elastic"
model = "springs"
density = "1200 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.25
anchor = "wall"
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
Box(2) = {0.75, 0, 0.25, 0.5, 0.75, 0.5};
Physical Volume("water") = {1};
Physical Surface("wall") = {3, 4, 5, 6};
Physical Volume("body") = {2};
)"};

/// In its place a slanted sheet that stands on the floor: 0.7762 m x 0.75 m.
const Texts sheet = column.with("poisson_ratio = 0.25", "thickness = \"0.05 m\"")
                        .with("spacing = \"0.125 m\"", "spacing = \"0.0625 m\"")
                        .with("Box(2) = {0.75, 0, 0.25, 0.5, 0.75, 0.5};",
                              "Point(101) = {1, 0, 0.125};\nPoint(102) = {1.2, 0.75, 0.125};\n"
                              "Point(103) = {1.2, 0.75, 0.875};\nPoint(104) = {1, 0, 0.875};\n"
                              "Line(101) = {101, 102};\nLine(102) = {102, 103};\nLine(103) = {103, 104};\n"
                              "Line(104) = {104, 101};\nCurve Loop(101) = {101, 102, 103, 104};\n"
                              "Plane Surface(101) = {101};\n")
                        .with("Physical Volume(\"body\") = {2}", "Physical Surface(\"body\") = {101}");

std::vector<std::size_t> nodes_of(const ParticleSet& set) {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::elastic) nodes.push_back(i);
    return nodes;
}

TEST(SpaceBodies, a_solid_takes_its_room_and_stretches_as_its_material_does) {
    const auto meshed = mesh_texts(column);
    const ParticleSet& set = meshed.particles;
    const double cell = std::pow(0.125, 3);
    ASSERT_EQ(set.count(PartKind::elastic), 4U * 6 * 4);
    EXPECT_EQ(set.count(PartKind::fluid), 16U * 8 * 8 - 96);
    std::size_t clamped = 0;
    for (const std::size_t i : nodes_of(set)) {
        EXPECT_EQ(set.volume[i], cell);
        EXPECT_NEAR(set.mass[i], 1200 * cell, 1e-12);
        EXPECT_EQ(set.body[i], 0);
        EXPECT_EQ(set.fixed[i] != 0, set.position[i].y() < 0.125);
        clamped += set.fixed[i];
    }
    EXPECT_EQ(clamped, 16U);
    const auto& line = meshed.report.springs.at(0);
    EXPECT_EQ(line.anchored, 16U);
    EXPECT_EQ(line.bodies, 1);
    EXPECT_EQ(line.pieces, 1);
    EXPECT_EQ(line.bonds, 224U + 348);  // along edges and diagonals
    EXPECT_EQ(line.hinges, 0U);
    ASSERT_TRUE(line.cells);
    EXPECT_NEAR(line.cells->stiffened, 96.0 / 45, 1e-12);
    EXPECT_NEAR(line.cells->constants.youngs_modulus(), 1e6, 1e-6);
    // A strain of 1 along y costs as much as in the material, of the volume of all nodes: 1/2 c11.
    double energy = 0;
    for (const Bond& bond : set.bonds) {
        const Vec along = set.position[bond.b] - set.position[bond.a];
        energy += bond.stiffness * std::pow(along.y() * along.y() / along.norm(), 2);
    }
    const double c11 = 1e6 * 0.75 / (1.25 * 0.5);
    EXPECT_NEAR(energy / (96 * cell), 0.5 * c11, 1e-9 * c11);
}

TEST(SpaceBodies, hinges_lower_the_ratio_of_a_solid) {
    const auto meshed = mesh_texts(column.with("poisson_ratio = 0.25", "poisson_ratio = 0.1"));
    const auto& line = meshed.report.springs.at(0);
    EXPECT_GT(line.hinges, 0U);
    EXPECT_NEAR(line.cells->constants.poisson_ratio(), 0.1, 1e-12);
    EXPECT_NEAR(line.cells->constants.youngs_modulus(), 1e6, 1e-6);
}

TEST(SpaceBodies, a_stretched_lattice_keeps_the_modulus_and_says_so) {
    const auto meshed = mesh_texts(column.with("{0, 0, 0, 2, 1, 1}", "{0, 0, 0, 2.03, 1, 1}"));
    const auto& line = meshed.report.springs.at(0);
    EXPECT_EQ(meshed.particles.count(PartKind::elastic), 96U);
    EXPECT_NEAR(line.cells->constants.spacing, 0.125 * std::cbrt(1.015), 1e-9);
    EXPECT_NEAR(line.particle_mass, 1200 * std::pow(0.125, 3), 1e-9) << "that of what is drawn";
    EXPECT_NEAR(line.counted, 1.015, 1e-9);
    EXPECT_THAT(meshed.report.notes, Contains(HasSubstr("lattice stretched along x by 1.5 %")));
    for (const Bond& bond : meshed.particles.bonds)
        EXPECT_NEAR(bond.rest_length, (meshed.particles.position[bond.a] - meshed.particles.position[bond.b]).norm(),
                    1e-15);
}

TEST(SpaceBodies, two_columns_of_one_part_are_two_bodies_that_may_touch) {
    const auto meshed = mesh_texts(column
                                       .with("Physical Volume(\"water\")",
                                             "Box(3) = {1.5, 0, 0.25, 0.25, 0.5, 0.25};\n"
                                             "Physical Volume(\"water\")")
                                       .with("(\"body\") = {2}", "(\"body\") = {2, 3}"));
    const auto& line = meshed.report.springs.at(0);
    EXPECT_EQ(line.bodies, 2);
    EXPECT_EQ(line.pieces, 2);
    EXPECT_EQ(line.anchored, 16U + 4);
}

TEST(SpaceBodies, a_sheet_becomes_a_shell) {
    const auto meshed = mesh_texts(sheet);
    const ParticleSet& set = meshed.particles;
    const double area = 0.75 * std::hypot(0.2, 0.75);
    const Vec normal = Vec(0.75, -0.2, 0).normalized();
    double mass = 0, volume = 0;
    std::size_t clamped = 0;
    const auto nodes = nodes_of(set);
    ASSERT_GT(nodes.size(), 2 * area / (0.0625 * 0.0625));
    EXPECT_LT(nodes.size(), 2.5 * area / (0.0625 * 0.0625));  // those at the border stand for half or a quarter
    for (const std::size_t i : nodes) {
        mass += set.mass[i];
        volume += set.volume[i];
        EXPECT_NEAR(std::abs((set.position[i] - Vec(1, 0, 0)).dot(normal)), 0.03125, 1e-9);
        EXPECT_EQ(set.fixed[i] != 0, set.position[i].y() < 0.02) << set.position[i].transpose();
        clamped += set.fixed[i];
    }
    EXPECT_NEAR(mass / (1200 * 0.05 * area), 1, 1e-9);
    // Nodes at the border reach half a spacing beyond it, about: triangles there are not quite equilateral.
    EXPECT_NEAR(volume / (2 * 0.0625 * (0.75 + 0.0625) * (std::hypot(0.2, 0.75) + 0.0625)), 1, 0.03);
    EXPECT_EQ(clamped % 2, 0U);
    EXPECT_GE(clamped, 2U * 11);  // 0.75 m is 11.2 edges
    EXPECT_LE(clamped, 2U * 14);
    const auto& line = meshed.report.springs.at(0);
    EXPECT_EQ(line.anchored, clamped);
    EXPECT_EQ(line.pieces, 1);
    EXPECT_GT(line.dihedrals, 0U);
    ASSERT_TRUE(line.shell);
    EXPECT_NEAR(line.shell->constants.bending_stiffness(), 1e6 * std::pow(0.05, 3) / 12, 1e-9);
    EXPECT_EQ(line.shell->membrane_stiffness_asked, 5e4);
    EXPECT_LT(line.shell->constants.membrane_stiffness(), 5e4);
    const TriangleSurface& drawn = meshed.geometry.surface_set("body")->surface;
    const NearestTriangle nearest(drawn, 0.0625);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::fluid) {
            EXPECT_FALSE(nearest.nearest(set.position[i]));
        }
    EXPECT_LT(meshed.report.parts.front().kernel_sum_spread, 0.05);
}

TEST(SpaceBodies, gaps_beside_a_shell_are_said) {
    // Its sides end two spacings from the walls, its upper edge four.
    const auto said_of = [](const Texts& texts) { return mesh_texts(texts).report.warnings; };
    const auto gap = [](const std::string& text) {
        return Contains(AllOf(HasSubstr("water: a gap of "), HasSubstr(text)));
    };
    EXPECT_THAT(said_of(sheet), gap("a gap of 2 spacings near"));
    EXPECT_THAT(said_of(sheet), Contains(AllOf(HasSubstr("body: a gap at its edge near ("),
                                               HasSubstr("that 1.5 particles fit into, less than 3"))));
    const Texts apart = sheet.with("{1, 0, 0.125}", "{1, 0, 0.25}")
                            .with("{1.2, 0.75, 0.125}", "{1.2, 0.75, 0.25}")
                            .with("{1, 0, 0.875}", "{1, 0, 0.75}")
                            .with("{1.2, 0.75, 0.875}", "{1.2, 0.75, 0.75}");
    EXPECT_THAT(said_of(apart), Not(gap("")));
    EXPECT_THAT(said_of(apart), Not(Contains(HasSubstr("at its edge"))));
    // A second one faces it, four spacings away, of which the two shells take one.
    const std::string second = "Translate {0.254, 0, 0} { Duplicata { Surface{101}; } }\nPhysical Volume(\"water\")";
    EXPECT_THAT(
        said_of(apart.with("Physical Volume(\"water\")", second).with("(\"body\") = {101}", "(\"body\") = {101, 102}")),
        gap("less than 3"));
    // A solid that is askew, with nothing that holds a sheet.
    EXPECT_THAT(
        said_of(column.with("Physical Volume(\"water\")",
                            "Rotate {{0, 0, 1}, {1, 0.375, 0.5}, 0.1} { Volume{2}; }\nPhysical Volume(\"water\")")),
        gap("less than 3"));
    // A solid, a spacing from the wall.
    EXPECT_THAT(said_of(column.with("{0.75, 0, 0.25, 0.5, 0.75, 0.5}", "{0.75, 0, 0.125, 0.5, 0.625, 0.5}")),
                gap("a gap of 1 spacings near"));
    EXPECT_THAT(said_of(column), gap("a gap of 2 spacings near"));
}

TEST(SpaceBodies, solids_may_be_cut_out_of_the_fluid_or_stand_beside_it) {
    const auto over = mesh_texts(column);
    const auto cut =
        mesh_texts(column.with("Physical Volume(\"water\") = {1};\nPhysical Surface(\"wall\") = {3, 4, 5, 6};",
                               "v() = BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; };\n"
                               "Physical Volume(\"water\") = {v()};\n"
                               "Physical Surface(\"wall\") = {Surface In BoundingBox{-1, -1e-3, -1, 3, 1e-3, 2}, "
                               "Surface In BoundingBox{-1, 0.999, -1, 3, 1.001, 2}, "
                               "Surface In BoundingBox{-1, -1, -1e-3, 3, 2, 1e-3}, "
                               "Surface In BoundingBox{-1, -1, 0.999, 3, 2, 1.001}};"));
    EXPECT_EQ(cut.particles.count(PartKind::elastic), over.particles.count(PartKind::elastic));
    EXPECT_EQ(cut.particles.count(PartKind::fluid), over.particles.count(PartKind::fluid));
    EXPECT_EQ(cut.particles.count(PartKind::rigid), over.particles.count(PartKind::rigid));
    // A soft floor, deeper than any wall: 1 m x 1 m x 1 m.
    const auto floor = mesh_texts(column.with("{0.75, 0, 0.25, 0.5, 0.75, 0.5}", "{0.5, -1, 0, 1, 1, 1}"));
    EXPECT_EQ(floor.particles.count(PartKind::elastic), 8U * 8 * 8);
    EXPECT_EQ(floor.particles.count(PartKind::fluid), 16U * 8 * 8);
}

TEST(SpaceBodies, a_thin_solid_that_is_a_sheet_becomes_a_shell) {
    // 1.6 spacings thick, across the duct's axis, standing on its floor.
    const Texts thin =
        column.with("spacing = \"0.125 m\"", "spacing = \"0.0625 m\"")
            .with("Box(2) = {0.75, 0, 0.25, 0.5, 0.75, 0.5}", "Box(2) = {0.75, 0, 0.25, 0.1, 0.75, 0.5}");
    const auto meshed = mesh_texts(thin);
    EXPECT_THAT(meshed.report.notes, Contains(AllOf(HasSubstr("body: a sheet of 100 mm, from 100 mm to 100 mm thick"),
                                                    HasSubstr("it becomes a shell"))));
    const MeshReport::SpringLine& line = meshed.report.springs.at(0);
    ASSERT_TRUE(line.shell);
    const double bending = 1e6 * 0.1 * 0.1 * 0.1 / (12 * (1 - 0.25 * 0.25));
    EXPECT_NEAR(line.shell->constants.bending_stiffness() / bending, 1, 1e-9);
    EXPECT_GT(line.anchored, 10U);
    double mass = 0;
    for (const std::size_t i : nodes_of(meshed.particles)) {
        EXPECT_NEAR(std::abs(meshed.particles.position[i].x() - 0.8), 0.03125, 1e-9);
        mass += meshed.particles.mass[i];
    }
    EXPECT_NEAR(mass / (1200 * 0.1 * 0.75 * 0.5), 1, 0.01);
    EXPECT_THAT(fault_of(thin.with("0.1, 0.75, 0.5}", "0.1, 0.75, 0.1}")),
                AllOf(HasSubstr("scene.toml:16:8: 'body' is thinner than two spacings, 100 mm near ("),
                      HasSubstr("no sheet that could become a shell: its faces are not two"),
                      HasSubstr("draw the surface in its middle")));
}

TEST(SpaceBodies, a_thick_shell_holds_both_stiffnesses) {
    const auto meshed = mesh_texts(sheet.with("thickness = \"0.05 m\"", "thickness = \"0.2 m\"\npoisson_ratio = 0.3"));
    const auto& line = meshed.report.springs.at(0);
    EXPECT_NEAR(line.shell->constants.membrane_stiffness() / 2e5, 1, 1e-12);
    EXPECT_NEAR(line.shell->constants.bending_stiffness() / (1e6 * 8e-3 / 12 / 0.91), 1, 1e-12);
    EXPECT_THAT(fault_of(sheet.with("thickness", "lower_axial_stiffness = false\nthickness")),
                AllOf(HasSubstr("two layers 0.0625 m apart that stretch as 'body' does"), HasSubstr("thickness")));
}

TEST(SpaceBodies, wrong_ones_are_refused_with_what_to_do) {
    const auto replaced = [](const char* found, const char* by) { return fault_of(column.with(found, by)); };
    EXPECT_THAT(
        replaced("spacing = \"0.125 m\"", "spacing = \"0.125 m\"\narrangement = \"fcc\""),
        AllOf(
            HasSubstr("scene.toml:7:15: 'body' is a solid of springs, whose cells are built on the cubic lattice only"),
            HasSubstr("arrangement = \"square\"")));
    EXPECT_THAT(replaced("poisson_ratio = 0.25", "poisson_ratio = 0.3"), HasSubstr("more than 0.25"));
    EXPECT_THAT(replaced("{0.75, 0, 0.25, 0.5, 0.75, 0.5}", "{0.75, 0, 0.25, 0.1, 0.75, 0.1}"),
                AllOf(HasSubstr("'body' is thinner than two spacings"), HasSubstr("draw the surface in its middle")));
    EXPECT_THAT(replaced("poisson_ratio = 0.25", "thickness = \"1 cm\""),
                AllOf(HasSubstr("is a volume in the geometry"), HasSubstr("take `thickness` out")));
    EXPECT_THAT(fault_of(sheet.with("thickness = \"0.05 m\"\n", "")), HasSubstr("its thickness is missing"));
    EXPECT_THAT(replaced("anchor = \"wall\"", "anchor = \"walls\""),
                AllOf(HasSubstr("the geometry has nothing named 'walls'"), HasSubstr("did you mean 'wall'?")));
    EXPECT_THAT(replaced("{0.75, 0, 0.25, 0.5, 0.75, 0.5}", "{0.75, 0.25, 0.25, 0.5, 0.5, 0.5}"),
                HasSubstr("no node of 'body' is within 0.75 spacings of 'wall'"));
    EXPECT_THAT(fault_of(sheet.with("{1, 0, 0.125}", "{1.14, 0.6, 0.6}")
                             .with("{1, 0, 0.875}", "{1.14, 0.6, 0.875}")
                             .with("{1.2, 0.75, 0.125}", "{1.2, 0.75, 0.6}")),
                HasSubstr("less than 16 particles"));
}

TEST(SpaceBodies, a_body_at_the_side_of_the_box_is_noted) {
    const auto drawn_as = [](const char* box) {
        return mesh_texts(column.with("{0.75, 0, 0.25, 0.5, 0.75, 0.5}", box)).report;
    };
    const auto at_a_side = drawn_as("{0, 0, 0.25, 0.5, 0.75, 0.5}");
    EXPECT_THAT(at_a_side.notes, Contains(HasSubstr("body: its springs end at the side of the box across x")));
    EXPECT_THAT(at_a_side.warnings, Not(Contains(HasSubstr("its springs end"))));
    const auto through = drawn_as("{0, 0, 0.25, 2, 0.75, 0.5}");
    EXPECT_THAT(through.notes, Not(Contains(HasSubstr("its springs end"))));
    EXPECT_THAT(through.warnings, Not(Contains(HasSubstr("its springs end"))));
    const auto cut = mesh_texts(column.with("{0.75, 0, 0.25, 0.5, 0.75, 0.5}", "{0, 0, 0.25, 2, 0.75, 0.5}")
                                    .with("poisson_ratio", "bonds_within = \"0.15 m\"\npoisson_ratio"));
    EXPECT_THAT(
        cut.report.warnings,
        Contains(AllOf(HasSubstr("body: its springs end at the side of the box across x, which is periodic, near "
                                 "(62.5, 187.5, 312.5) mm"),
                       HasSubstr("bonds_within: cells go on there"))));
}

}  // namespace
}  // namespace dmp::tests::space_bodies_tests
