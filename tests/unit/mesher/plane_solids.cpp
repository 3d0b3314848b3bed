// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of springs in geometries in 2-D.
#include <cmath>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::plane_solids_tests {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// The channel with a block of 0.5 m x 1 m on its bottom, clamped there, drawn over the water.
const Texts block{channel.scene + R"([[part]]
name = "block"
kind = "elastic"
model = "springs"
density = "1200 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.25
anchor = "wall"
)",
                  channel.cad_geometry + R"(Point(10) = {1.75, 0, 0};
Point(11) = {2.25, 0, 0};
Point(12) = {2.25, 1, 0};
Point(13) = {1.75, 1, 0};
Line(10) = {10, 11};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 10};
Curve Loop(2) = {10, 11, 12, 13};
Plane Surface(2) = {2};
Physical Surface("block") = {2};
)"};

std::size_t count_of(const ParticleSet& set, const std::string& part) {
    std::size_t count = 0;
    for (const int p : set.part) count += set.parts[static_cast<std::size_t>(p)].name == part ? 1 : 0;
    return count;
}

TEST(PlaneSolids, take_their_room_and_stretch_as_their_material_does) {
    const auto meshed = mesh_texts(block);
    const ParticleSet& set = meshed.particles;
    const double cell = 0.125 * 0.125;
    ASSERT_EQ(count_of(set, "block"), 4U * 8);
    EXPECT_EQ(count_of(set, "water"), 32U * 16 - 32);
    EXPECT_EQ(count_of(set, "wall"), 32U * 6);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::elastic) continue;
        EXPECT_EQ(set.volume[i], cell);
        EXPECT_NEAR(set.mass[i], 1200 * cell, 1e-12);
        EXPECT_EQ(set.body[i], 0);
        EXPECT_EQ(set.fixed[i] != 0, set.position[i].y() < 0.125);
    }
    const auto& line = meshed.report.springs.at(0);
    EXPECT_EQ(line.anchored, 4U);
    EXPECT_EQ(line.bodies, 1);
    EXPECT_EQ(line.pieces, 1);
    EXPECT_EQ(line.bonds, 3U * 8 + 4 * 7 + 2 * 3 * 7);
    ASSERT_TRUE(line.cells);
    EXPECT_NEAR(line.cells->stiffened, 32.0 / 21, 1e-12);
    EXPECT_NEAR(line.cells->constants.youngs_modulus(), 1e6, 1e-6);
    // A strain of 1 along y costs as much as in the material held in its depth, of the area of all nodes: 1/2 c11.
    double energy = 0;
    for (const Bond& bond : set.bonds) {
        const Vec along = set.position[bond.b] - set.position[bond.a];
        energy += bond.stiffness * std::pow(along.y() * along.y() / along.norm(), 2);
    }
    const double c11 = 1e6 * 0.75 / (1.25 * 0.5);
    EXPECT_NEAR(energy / (32 * cell), 0.5 * c11, 1e-9 * c11);
    EXPECT_THAT(meshed.report.text(),
                AllOf(HasSubstr("give E = 1e+06 Pa, nu = 0.25"), HasSubstr("1/1.52 of the area")));
    EXPECT_NEAR(meshed.report.parts.at(0).volume_error(), 0, 1e-12);
}

TEST(PlaneSolids, know_where_their_drawn_surface_is) {
    const ParticleSet set = mesh_texts(block).particles;
    std::size_t outer = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::elastic) continue;
        const Vec& x = set.position[i];
        const SolidSurface surface = set.surface(i);
        // The block reaches from 1.75 to 2.25 m along x and from 0 to 1 m along y.
        const double sides = std::min(x[0] - 1.75, 2.25 - x[0]), ends = std::min(x[1], 1 - x[1]);
        EXPECT_NEAR(surface.depth, std::min(sides, ends), 1e-12);
        EXPECT_NEAR(surface.normal.norm(), 1, 1e-12);
        const bool by_side = sides < ends - 1e-9;
        outer += by_side ? 1 : 0;
        if (by_side) {
            EXPECT_NEAR(surface.normal[0], x[0] < 2 ? -1 : 1, 1e-9);
            EXPECT_NEAR(surface.depth + surface.opposite, 0.5, 0.003);
        }
    }
    EXPECT_GT(outer, 10U);
}

TEST(PlaneSolids, have_the_mass_of_what_is_drawn) {
    for (const double radius : {0.32, 0.4, 0.53}) {
        std::ostringstream points, lines;
        points.precision(17);
        constexpr int sides = 60;
        for (int n = 0; n < sides; ++n) {
            const double angle = n * 2 * std::numbers::pi / sides;
            points << "Point(" << 10 + n << ") = {" << 2 + radius * std::cos(angle) << ", "
                   << 1 + radius * std::sin(angle) << ", 0};\n";
            lines << "Line(" << 10 + n << ") = {" << 10 + n << ", " << 10 + (n + 1) % sides << "};\n";
        }
        const Texts disc{block.with("anchor = \"wall\"\n", "").scene,
                         channel.cad_geometry + points.str() + lines.str() +
                             "Curve Loop(2) = {10:69};\nPlane Surface(2) = {2};\nPhysical Surface(\"block\") = {2};\n"};
        for (const Texts& texts :
             {disc, disc.with("model = \"springs\"", "model = \"springs\"\nbonds_within = \"0.19 m\"")}) {
            const auto meshed = mesh_texts(texts);
            const ParticleSet& set = meshed.particles;
            double mass = 0, volume = 0;
            for (std::size_t i = 0; i < set.size(); ++i)
                if (set.kind(i) == PartKind::elastic) {
                    mass += set.mass[i];
                    volume += set.volume[i];
                }
            const double drawn = sides / 2.0 * std::sin(2 * std::numbers::pi / sides) * radius * radius;
            EXPECT_NEAR(mass / (1200 * drawn), 1, 1e-9);
            const double counted = static_cast<double>(count_of(set, "block")) * 0.125 * 0.125;
            EXPECT_NEAR(volume, counted, 1e-12);
            EXPECT_NEAR(meshed.report.springs.at(0).counted, counted / drawn, 1e-9);
            EXPECT_GT(std::abs(counted / drawn - 1), 0.003);
            EXPECT_THAT(meshed.report.text(), HasSubstr("of what is drawn, whose mass they have"));
        }
    }
}

TEST(PlaneSolids, may_be_cut_out_of_the_fluid) {
    const Texts hole = block.with("Plane Surface(1) = {1};\n", "")
                           .with("Plane Surface(2) = {2};\n",
                                 "Line(14) = {11, 2};\nLine(15) = {1, 10};\n"
                                 "Curve Loop(3) = {15, -13, -12, -11, 14, 2, 3, 4};\n"
                                 "Plane Surface(1) = {3};\nPlane Surface(2) = {2};\n")
                           .with("Line(1) = {1, 2};\n", "")
                           .with("Curve Loop(1) = {1, 2, 3, 4};\n", "")
                           .with("Physical Curve(\"wall\") = {1, 3};\n", "")
                           .with("Physical Surface(\"block\")",
                                 "Physical Curve(\"wall\") = {3, 10, 14, 15};\nPhysical Surface(\"block\")");
    const auto meshed = mesh_texts(hole), over = mesh_texts(block);
    ASSERT_EQ(meshed.particles.size(), over.particles.size());
    for (std::size_t i = 0; i < over.particles.size(); ++i)
        EXPECT_LT((meshed.particles.position[i] - over.particles.position[i]).norm(), 1e-12);
    EXPECT_EQ(meshed.particles.bonds.size(), over.particles.bonds.size());
    EXPECT_NEAR(meshed.report.parts.at(0).target, over.report.parts.at(0).target, 1e-12);
}

TEST(PlaneSolids, may_stand_beside_the_fluid) {
    // A soft floor below the water, from y = -0.5 m on: the box reaches down to it.
    const Texts floor = block.with("{1.75, 0, 0}", "{1, 0, 0}")
                            .with("{2.25, 0, 0}", "{1, -0.5, 0}")
                            .with("{2.25, 1, 0}", "{3, -0.5, 0}")
                            .with("{1.75, 1, 0}", "{3, 0, 0}")
                            .with("anchor = \"wall\"\n", "");
    const auto meshed = mesh_texts(floor);
    EXPECT_EQ(count_of(meshed.particles, "block"), 16U * 4);
    EXPECT_EQ(count_of(meshed.particles, "water"), 32U * 16);
    EXPECT_LE(meshed.particles.box.low.y(), -0.4375);
    for (std::size_t i = 0; i < meshed.particles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            ASSERT_GT((meshed.particles.position[i] - meshed.particles.position[j]).norm(), 0.12);
}

TEST(PlaneSolids, of_borders_on_the_lattice_take_the_rows_of_their_low_sides) {
    // Sides at x = 1.8125 and 2.3125 and a top at 0.9375 run through points of the lattice.
    const Texts on_points = block.with("{1.75, 0, 0}", "{1.8125, 0, 0}")
                                .with("{2.25, 0, 0}", "{2.3125, 0, 0}")
                                .with("{2.25, 1, 0}", "{2.3125, 0.9375, 0}")
                                .with("{1.75, 1, 0}", "{1.8125, 0.9375, 0}");
    const auto meshed = mesh_texts(on_points);
    EXPECT_EQ(count_of(meshed.particles, "block"), 4U * 7);
    EXPECT_EQ(count_of(meshed.particles, "water"), 32U * 16 - 28);
    EXPECT_EQ(count_of(meshed.particles, "wall"), 32U * 6);
}

TEST(PlaneSolids, without_a_cell_in_a_corner_leave_it_to_nobody_or_to_the_fluid) {
    // A ramp, whose toe has no whole cell: as fluid where it is drawn over the water, not as wall where it is cut out.
    const Texts ramp =
        block.with("{1.75, 1, 0}", "{2.25, 1, 0}").with("{2.25, 1, 0};\nPoint(13)", "{3.25, 0, 0};\nPoint(13)");
    const auto over = mesh_texts(ramp);
    for (std::size_t i = 0; i < over.particles.size(); ++i) {
        const double y = over.particles.position[i].y();
        EXPECT_EQ(over.particles.kind(i) == PartKind::rigid, y < 0 || y > 2);
    }
    EXPECT_EQ(over.particles.size() - count_of(over.particles, "wall"), 32U * 16);
}

TEST(PlaneSolids, do_not_close_the_whole_of_a_side_that_they_touch) {
    EXPECT_THAT(fault_of(block.with("Physical Curve(\"wall\") = {1, 3}", "Physical Curve(\"wall\") = {3}")
                             .with("anchor = \"wall\"\n", "")),
                HasSubstr("the boundary of 'water' is open between"));
}

TEST(PlaneSolids, keep_fluid_off_in_every_fill) {
    for (const char* fill : {"lattice", "relaxed", "sampled"}) {
        const auto meshed = mesh_texts(
            block.with("spacing = \"0.125 m\"", "spacing = \"0.125 m\"\nfill = \"" + std::string(fill) + "\""));
        const ParticleSet& set = meshed.particles;
        EXPECT_EQ(count_of(set, "block"), 4U * 8);
        EXPECT_NEAR(static_cast<double>(count_of(set, "water")), 480, 2) << fill;
        for (std::size_t i = 0; i < set.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const bool at_the_block = (set.kind(i) == PartKind::elastic) != (set.kind(j) == PartKind::elastic);
                if (!at_the_block) continue;
                EXPECT_GT((set.position[i] - set.position[j]).norm(), 0.6 * 0.125) << fill;
            }
    }
}

TEST(PlaneSolids, of_curved_shape_leave_out_what_is_in_no_cell) {
    // A slanted block, clamped at named points.
    const Texts slanted =
        block.with("{2.25, 1, 0}", "{2.75, 1, 0}")
            .with("{1.75, 1, 0}", "{2.0, 1.2, 0}")
            .with("anchor = \"wall\"", "anchor = \"feet\"")
            .with("Physical Surface(\"block\")", "Physical Point(\"feet\") = {10, 11};\nPhysical Surface(\"block\")");
    const auto meshed = mesh_texts(slanted);
    EXPECT_THAT(meshed.report.notes, Contains(HasSubstr("lattice points in it belong to no whole cell of springs")));
    EXPECT_EQ(meshed.report.springs.at(0).pieces, 1);
    EXPECT_GE(meshed.report.springs.at(0).anchored, 2U);
    EXPECT_LE(meshed.report.springs.at(0).anchored, 4U);
}

TEST(PlaneSolids, gaps_beside_them_are_said) {
    EXPECT_THAT(mesh_texts(block).report.warnings, Not(Contains(HasSubstr("a gap of"))));
    EXPECT_THAT(mesh_texts(block.with("{2.25, 1, 0}", "{2.25, 1.75, 0}").with("{1.75, 1, 0}", "{1.75, 1.75, 0}"))
                    .report.warnings,
                Contains(AllOf(HasSubstr("water: a gap of 2 spacings near"), HasSubstr("less than 3 particles"))));
}

TEST(PlaneSolids, that_cannot_be_are_refused_with_what_to_do) {
    EXPECT_THAT(fault_of(block.with("{2.25, 1, 0}", "{1.85, 1, 0}").with("{2.25, 0, 0}", "{1.85, 0, 0}")),
                HasSubstr("'block' is too thin for a solid of springs: no cell of the lattice fits in it"));
    EXPECT_THAT(fault_of(block.with("poisson_ratio = 0.25", "poisson_ratio = 0.4")),
                HasSubstr("cannot have a Poisson ratio of more than 0.25"));
    EXPECT_THAT(fault_of(block.with("spacing = \"0.125 m\"", "spacing = \"0.125 m\"\narrangement = \"hexagonal\"")),
                HasSubstr("whose cells are built on the square lattice only"));
    EXPECT_THAT(fault_of(block.with("density = \"1200 kg/m^3\"", "mass_per_length = \"5 kg/m\"\nthickness = \"1 m\"")),
                HasSubstr("'block' is a surface in the geometry, a solid of springs, which has no mass_per_length"));
    EXPECT_THAT(fault_of(block.with("Physical Surface(\"block\") = {2}", "Physical Curve(\"block\") = {11}")),
                HasSubstr("'block' is a curve in the geometry, a strip of springs, which has no density"));
    EXPECT_THAT(fault_of(block.with("density = \"1200 kg/m^3\"", "density = \"1200 kg/m^3\"\ncross_bonds = true")),
                HasSubstr("part 'block': cross_bonds is for strips, and a part with a density is an area"));
    EXPECT_THAT(fault_of(block.with("youngs_modulus = \"1 MPa\"\n", "")), HasSubstr("youngs_modulus is missing"));
    EXPECT_THAT(
        fault_of(block.with("anchor = \"wall\"", "anchor = \"feet\"")
                     .with("Physical Surface(\"block\")",
                           "Point(20) = {0.5, 1, 0};\nPhysical Point(\"feet\") = {20};\nPhysical Surface(\"block\")")),
        HasSubstr("no node of 'block' is next to 'feet'"));
}

TEST(PlaneSolids, go_on_through_periodic_sides_and_where_they_do_not_it_is_said) {
    const Texts at_a_side = block.with("{1.75, 0, 0}", "{0, 0, 0}").with("{1.75, 1, 0}", "{0, 1, 0}");
    const auto meshed = mesh_texts(at_a_side);
    EXPECT_THAT(meshed.report.notes, Contains(HasSubstr("block: its springs end at the side of the box across x")));
    EXPECT_THAT(meshed.report.warnings, Not(Contains(HasSubstr("its springs end"))));
    const Texts through = at_a_side.with("{2.25, 0, 0}", "{4, 0, 0}").with("{2.25, 1, 0}", "{4, 1, 0}");
    const auto whole = mesh_texts(through);
    EXPECT_THAT(whole.report.notes, Not(Contains(HasSubstr("its springs end"))));
    EXPECT_THAT(whole.report.warnings, Not(Contains(HasSubstr("its springs end"))));
    // Along x and y, and the diagonals of 32 x 7 cells.
    EXPECT_EQ(whole.report.springs.at(0).bonds, 32U * 8 + 32 * 7 + 2 * 32 * 7);
    for (const Bond& bond : whole.particles.bonds) EXPECT_LT(bond.rest_length, 0.18);
    const auto cut = mesh_texts(through.with("anchor =", "bonds_within = \"0.19 m\"\nanchor ="));
    EXPECT_THAT(
        cut.report.warnings,
        Contains(AllOf(HasSubstr("block: its springs end at the side of the box across x, which is periodic, near "
                                 "(62.5, 187.5) mm"),
                       HasSubstr("bonds_within: cells go on there"))));
}

TEST(PlaneSolids, end_at_planes_of_symmetry_and_it_is_said) {
    const Texts half = block.with("{2.25, 0, 0}", "{4, 0, 0}").with("{2.25, 1, 0}", "{4, 1, 0}");
    const auto meshed = mesh_texts(half.with("periodic = [\"x\"]", "symmetry = [\"x_low\", \"x_high\"]"));
    EXPECT_THAT(meshed.report.warnings,
                Contains(AllOf(HasSubstr("block: its springs end at the side of the box across x, a plane of symmetry"),
                               HasSubstr("bonds_within: the nodes of cells stay on the plane"))));
}

}  // namespace
}  // namespace dmp::tests::plane_solids_tests
