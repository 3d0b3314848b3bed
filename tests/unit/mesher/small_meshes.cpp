// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::small_meshes_tests {
namespace {

std::size_t count_of(const ParticleSet& set, const std::string& part) {
    std::size_t count = 0;
    for (const int p : set.part) count += set.parts[p].name == part ? 1 : 0;
    return count;
}

/// Smallest distance of any two particles, without looking across periodic sides [spacings].
double smallest_distance(const ParticleSet& set) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) smallest = std::min(smallest, (set.position[i] - set.position[j]).norm());
    return smallest / set.spacing;
}

std::vector<Vec> clamped_nodes(const ParticleSet& set) {
    std::vector<Vec> nodes;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::elastic && set.fixed[i] != 0) nodes.push_back(set.position[i]);
    return nodes;
}

TEST(ChannelMesh, OfAnAreaThatItsGroupNamesTwiceIsOfTheAreaOnce) {
    const auto positions = [](const Texts& texts) { return mesh_texts(texts).particles.position; };
    EXPECT_EQ(positions(channel.with("(\"water\") = {1}", "(\"water\") = {1, 1}")), positions(channel));
}

TEST(ChannelMesh, EndsAtPlanesOfSymmetry) {
    // Walls above and below, planes at both ends; 4 m are a whole number of cells of about 0.13 m after stretching.
    const Meshed meshed = mesh_texts(
        channel.with("periodic = [\"x\"]", "symmetry = [\"x_low\", \"x_high\"]").with("\"0.125 m\"", "\"0.13 m\""));
    const ParticleSet& set = meshed.particles;
    EXPECT_TRUE(set.mirrored[0][0] && set.mirrored[0][1]);
    EXPECT_FALSE(set.mirrored[1][0] || set.mirrored[1][1] || set.periodic[0]);
    EXPECT_EQ(set.box.low[0], 0);
    EXPECT_EQ(set.box.high[0], 4);
    const double step = 4.0 / 31;
    double first = 4, last = 0;
    for (const Vec& position : set.position) {
        first = std::min(first, position[0]);
        last = std::max(last, position[0]);
    }
    EXPECT_NEAR(first, step / 2, 1e-12);
    EXPECT_NEAR(last, 4 - step / 2, 1e-12);
    EXPECT_EQ(count_of(set, "wall") % 31, 0U) << "whole rows, and nothing beyond the planes";
    ASSERT_FALSE(meshed.report.notes.empty());
    EXPECT_NE(meshed.report.notes.front().find("reaches the plane of symmetry"), std::string::npos);
}

TEST(ChannelMesh, CountsVolumesAndMasses) {
    const Meshed meshed = mesh_texts(channel);
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(count_of(set, "water"), 32U * 16);
    EXPECT_EQ(count_of(set, "wall"), 32U * 6);
    EXPECT_EQ(smallest_distance(set), 1);
    EXPECT_EQ(set.box.low, Vec(0, -0.3125, 0));  // periodic along x, around all centres along y
    EXPECT_EQ(set.box.high, Vec(4, 2.3125, 0));
    for (std::size_t i = 0; i < set.size(); ++i) {
        EXPECT_EQ(set.volume[i], 1.0 / 64);
        EXPECT_EQ(set.mass[i], 1000.0 / 64);
    }
    ASSERT_EQ(meshed.report.parts.size(), 2U);
    EXPECT_EQ(meshed.report.parts[0].target, 8);
    EXPECT_EQ(meshed.report.parts[0].reached, 8);
    EXPECT_EQ(meshed.report.parts[1].target, 8);  // metres of wall
    EXPECT_EQ(meshed.report.parts[1].reached, 8);
    EXPECT_NEAR(meshed.report.parts[0].kernel_sum_mean, 1.00514234077735619, 1e-12);  // that of a full lattice
    EXPECT_NEAR(meshed.report.parts[0].kernel_sum_spread, 0, 1e-7);
}

TEST(ChannelMesh, KernelSumIsThatOfTheScenesKernel) {
    const Meshed meshed =
        mesh_texts(channel.with("[flow]", "[numerics]\nscheme = \"plain\"\nkernel = \"lucy\"\nsupport = 2.6\n[flow]"));
    EXPECT_NEAR(meshed.report.parts[0].kernel_sum_mean, 1.00003, 1e-5);
}

TEST(ChannelMesh, ReportIsATableForPeople) {
    const std::string text = mesh_texts(flap_channel).report.text();
    EXPECT_THAT(text, testing::HasSubstr("water          fluid"));
    EXPECT_THAT(text, testing::HasSubstr("7.719e+06 / 7.719e+06 mm^2"));
    EXPECT_THAT(text, testing::HasSubstr("springs of flap: 1 body, 25 bonds of k_b = 200 N/m, 32 hinges of"));
    EXPECT_THAT(text, testing::HasSubstr("2 nodes clamped\n  give EI = 3 N*m^2, EA = 100 N, GA_s ="));
    EXPECT_THAT(text, testing::HasSubstr("note: water: "));
}

TEST(ChannelMesh, ALatticeThatDoesNotFitIsStretchedAndNoted) {
    const Meshed meshed = mesh_texts(channel.with("0.125 m", "0.15 m"));
    const auto columns = static_cast<std::size_t>(std::lround(4 / 0.15));
    EXPECT_EQ(count_of(meshed.particles, "water") % columns, 0U);
    EXPECT_NEAR(meshed.particles.volume[0], 0.15 * 4 / static_cast<double>(columns), 1e-12);
    EXPECT_THAT(meshed.report.notes, testing::ElementsAre("lattice stretched along x by -1.23457 % so that a whole "
                                                          "number of cells makes one period"));
}

TEST(FlapMesh, IsClampedAtItsRoot) {
    const Meshed meshed = mesh_texts(flap_channel);
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(count_of(set, "flap"), 2U * 9);
    EXPECT_EQ(clamped_nodes(set), (std::vector<Vec>{{2 - 0.0625, 0, 0}, {2 + 0.0625, 0, 0}}));
    for (std::size_t i = 0; i < set.size(); ++i) {
        const bool springs = set.kind(i) == PartKind::elastic;
        EXPECT_EQ(set.seated[i], 0);  // no wall particle is left where the root stands
        EXPECT_EQ(set.body[i], springs ? 0 : -1);
        if (springs) {
            const bool is_at_an_end = set.position[i][1] < 0.0625 || set.position[i][1] > 1 - 0.0625;
            EXPECT_EQ(set.mass[i], 10 * 0.125 / (is_at_an_end ? 4 : 2));
            EXPECT_EQ(set.volume[i], 0.125 * 0.125);
        }
    }
    EXPECT_GT(smallest_distance(set), 0.5);
}

TEST(FlapMesh, HasTheMassOfItsLength) {
    for (const char* top : {"{2, 1, 0}", "{2, 1.3, 0}"}) {
        const ParticleSet set = mesh_texts(flap_channel.with("{2, 1, 0}", top)).particles;
        double mass = 0;
        for (std::size_t i = 0; i < set.size(); ++i)
            if (set.kind(i) == PartKind::elastic) mass += set.mass[i];
        EXPECT_NEAR(mass, 10 * (top[4] == '1' && top[5] == ',' ? 1 : 1.3), 1e-12);
    }
}

TEST(FlapMesh, OfFewCellsSwingsTooSlowly) {
    const auto warnings = [](const Texts& texts) { return mesh_texts(texts).report.warnings; };
    EXPECT_THAT(
        warnings(flap_channel.with("{2, 1, 0}", "{2, 0.5, 0}")),
        testing::Contains(testing::AllOf(testing::HasSubstr("a curve of 'flap' is 4 cells long"),
                                         testing::HasSubstr("clamped at one end it swings about 11 % too slowly"))));
    EXPECT_THAT(warnings(flap_channel), testing::Not(testing::Contains(testing::HasSubstr("cells long"))));
}

TEST(FlapMesh, IsSeatedWhereItIsDrawnNearAWall) {
    // The lower row stands 0.11 m above the wall's first one, nearer than the contact range of 0.119 m.
    const Meshed meshed =
        mesh_texts(flap_channel.with("{2, 0, 0}", "{1.0625, 0.11, 0}")
                       .with("{2, 1, 0}", "{3.0625, 0.11, 0}")
                       .with("[flow]", "[contact]\nrange = 0.95\n[numerics]\nscheme = \"plain\"\n[flow]"));
    const ParticleSet& set = meshed.particles;
    std::size_t seated = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        EXPECT_EQ(set.seated[i] != 0, set.kind(i) == PartKind::elastic && set.position[i][1] < 0.1);
        seated += set.seated[i];
    }
    EXPECT_EQ(seated, 17U);
    const Meshed touching = mesh_texts(flap_channel.with("{2, 0, 0}", "{1.0625, 0.11, 0}")
                                           .with("{2, 1, 0}", "{3.0625, 0.11, 0}")
                                           .with("[flow]", "[contact]\nrange = 0.8\n[flow]"));
    for (const auto mark : touching.particles.seated) EXPECT_EQ(mark, 0);
}

TEST(ChannelMesh, GapsTooNarrowForThreeParticlesAreSaid) {
    const Texts narrow = channel.with("{4, 2, 0}", "{4, 0.3, 0}").with("{0, 2, 0}", "{0, 0.3, 0}");
    EXPECT_THAT(mesh_texts(narrow).report.warnings,
                testing::Contains(testing::AllOf(testing::HasSubstr("water: a gap of 2.4 spacings near ("),
                                                 testing::HasSubstr(", 150) mm, less than 3 particles, as are 100 % of "
                                                                    "its edge"))));
    EXPECT_THAT(mesh_texts(flap_channel.with("{2, 1, 0}", "{2, 1.7, 0}")).report.warnings,
                testing::Contains("flap: a gap at its end near (2, 1.7) m that 1.9 particles fit into, less "
                                  "than 3"));
    // Nearer to the wall than a spacing, where its other end is held.
    EXPECT_THAT(
        mesh_texts(flap_channel.with("{2, 1, 0}", "{2, 1.9, 0}")).report.warnings,
        testing::Contains(testing::HasSubstr("flap: a gap at its end near (2, 1.9) m that 0.3 particles fit into")));
    // 3.5 spacings from the wall, as the fluid's first layer is half a spacing from it; and a bridge has no loose end.
    EXPECT_THAT(mesh_texts(flap_channel.with("{2, 1, 0}", "{2, 1.5625, 0}")).report.warnings,
                testing::Not(testing::Contains(testing::HasSubstr("gap"))));
    EXPECT_THAT(mesh_texts(flap_channel.with("{2, 1, 0}", "{2, 2, 0}")).report.warnings,
                testing::Not(testing::Contains(testing::HasSubstr("gap"))));
}

TEST(FlapMesh, ThroughItsWallOrLooseOnItIsWarnedOf) {
    const auto warnings = [](const Texts& texts) { return mesh_texts(texts).report.warnings; };
    const auto opens = testing::Contains(testing::HasSubstr("flap: it "));
    EXPECT_THAT(warnings(flap_channel), testing::Not(opens));
    const Texts through = flap_channel.with("{2, 0, 0}", "{2, -0.5, 0}");
    EXPECT_THAT(
        warnings(through),
        testing::Contains("flap: it goes through the boundary of the fluid, and is outside near (2, -0.5) m: where "
                          "it moves it opens the wall; let it end on the wall"));
    const Texts loose = flap_channel.with("anchor = \"root\"\n", "").with("Physical Point(\"root\") = {10};\n", "");
    EXPECT_THAT(warnings(loose),
                testing::Contains("flap: it touches the boundary of the fluid near (2, 0) m and is held nowhere: fluid "
                                  "passes between; give it an `anchor`, or keep it apart"));
    EXPECT_THAT(warnings(loose.with("{2, 0, 0}", "{2, 0.5, 0}")), testing::Not(opens));
    // Along the period there is no wall to go through.
    EXPECT_THAT(warnings(flap_channel.with("{2, 1, 0}", "{4.5, 1, 0}")), testing::Not(opens));
}

TEST(FlapMesh, IsClampedWhereItEndsOnACurve) {
    const Meshed at_point = mesh_texts(flap_channel);
    const Texts on_wall =
        flap_channel.with("anchor = \"root\"", "anchor = \"wall\"").with("Physical Point(\"root\") = {10};\n", "");
    EXPECT_EQ(mesh_texts(on_wall).particles.fixed, at_point.particles.fixed);
    // Both ends, of a bridge from wall to wall.
    const Meshed bridge = mesh_texts(on_wall.with("{2, 1, 0}", "{2, 2, 0}"));
    EXPECT_EQ(bridge.report.springs[0].anchored, 4U);
}

TEST(ChannelMesh, WallsMayBeSelectedByWhereTheyLie) {
    const Texts selected =
        channel
            .with("[particles]",
                  "[[select]]\nname = \"wall\"\nof = \"water\"\nnormal = [0, 1, 0]\nangle = \"5 deg\"\n"
                  "[[select]]\nname = \"floor\"\nof = \"water\"\ny = 0\n[particles]")
            .with("[flow]", "[[part]]\nname = \"floor\"\nkind = \"rigid\"\n[flow]")
            .with("Physical Curve(\"wall\") = {1, 3};\n", "");
    const Meshed named = mesh_texts(channel), meshed = mesh_texts(selected);
    EXPECT_EQ(meshed.particles.size(), named.particles.size());
    EXPECT_EQ(meshed.report.parts[1].name, "wall");
    EXPECT_EQ(2 * meshed.report.parts[1].particles, named.report.parts[1].particles);
    EXPECT_EQ(meshed.report.parts[2].particles, meshed.report.parts[1].particles);
}

TEST(FlapMesh, IsFreeWithoutAnAnchor) {
    const Meshed meshed =
        mesh_texts(flap_channel.with("anchor = \"root\"\n", "").with("Physical Point(\"root\") = {10};\n", ""));
    EXPECT_TRUE(clamped_nodes(meshed.particles).empty());
    EXPECT_EQ(meshed.report.springs.at(0).anchored, 0U);
}

TEST(FlapMesh, AnAnchorBetweenTwoColumnsClampsOneOfThem) {
    // y = 0.4375 is exactly half way between the columns at 0.375 and 0.5.
    const Texts texts = flap_channel.with("Point(11)", "Point(12) = {2, 0.4375, 0};\nPoint(11)")
                            .with("(\"root\") = {10}", "(\"root\") = {12}");
    const auto clamped = clamped_nodes(mesh_texts(texts).particles);
    ASSERT_EQ(clamped.size(), 2U);
    EXPECT_EQ(clamped[0][1], 0.375);
    EXPECT_EQ(clamped[1][1], 0.375);
}

TEST(FlapMesh, OnACornerOfTwoLinesIsOneBody) {
    const Texts texts = flap_channel.with("Physical Curve(\"flap\") = {10}",
                                          "Point(12) = {3, 1.5, 0};\nLine(11) = {11, 12};\n"
                                          "Physical Curve(\"flap\") = {10, 11}");
    const Meshed meshed = mesh_texts(texts);
    EXPECT_EQ(meshed.report.springs.at(0).bodies, 1);
    EXPECT_EQ(count_of(meshed.particles, "flap"), 2U * 18);  // 2.118 m: 17 cells
}

TEST(WallsThatMeet, ShareTheirCornersWithoutDoubles) {
    // A closed box of 4 m x 2 m: the lid is a part of its own.
    const Texts box = channel.with("periodic = [\"x\"]\n", "")
                          .with("Physical Curve(\"wall\") = {1, 3}",
                                "Physical Curve(\"lid\") = {3};\nPhysical Curve(\"wall\") = {1, 2, 4}")
                          .with("[flow]", "[[part]]\nname = \"lid\"\nkind = \"rigid\"\n[flow]");
    const Meshed meshed = mesh_texts(box);
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(count_of(set, "water"), 32U * 16);
    // Three rows all around; the outermost point of each corner is 3.5 spacings away.
    EXPECT_EQ(count_of(set, "wall") + count_of(set, "lid"), 38U * 22 - 32 * 16 - 4);
    EXPECT_EQ(count_of(set, "lid"), 32U * 3);  // a corner is as near to both: the first part, the wall, has it
    EXPECT_EQ(smallest_distance(set), 1);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::rigid) continue;
        const Vec nearest = set.position[i].cwiseMax(Vec(0, 0, 0)).cwiseMin(Vec(4, 2, 0));
        EXPECT_NEAR(set.wall_distance[i], (nearest - set.position[i]).norm(), 1e-15);
        EXPECT_NEAR((set.wall_normal[i] - (nearest - set.position[i]).normalized()).norm(), 0, 1e-12);
    }
}

TEST(WallOnTheLattice, TakesThePointsOnItsSurface) {
    // A wall at y = 2.0625 goes through the centres of a row.
    const Meshed meshed = mesh_texts(channel.with("{4, 2, 0}", "{4, 2.0625, 0}").with("{0, 2, 0}", "{0, 2.0625, 0}"));
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(count_of(set, "water"), 32U * 16);
    std::size_t on_surface = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::rigid || set.wall_distance[i] > 0) continue;
        EXPECT_EQ(set.position[i][1], 2.0625);
        EXPECT_NEAR((set.wall_normal[i] - Vec(0, -1, 0)).norm(), 0, 1e-12);  // towards the fluid
        ++on_surface;
    }
    EXPECT_EQ(on_surface, 32U);
}

/// The channel with oil above a border at y = `border`.
Texts two_fluids(const std::string& border) {
    return channel
        .with("Line(2) = {2, 3};",
              "Point(5) = {4, " + border + ", 0};\nPoint(6) = {0, " + border +
                  ", 0};\nLine(2) = {2, 5};\nLine(5) = {5, 6};\nLine(6) = {5, 3};\nLine(7) = {4, 6};")
        .with("Line(4) = {4, 1};", "Line(4) = {6, 1};")
        .with("{1, 2, 3, 4};\n", "{1, 2, 5, 4};\nCurve Loop(2) = {6, 3, 7, -5};\nPlane Surface(2) = {2};\n")
        .with("Physical Curve", "Physical Surface(\"oil\") = {2};\nPhysical Curve")
        .with("[flow]",
              "[[part]]\nname = \"oil\"\nkind = \"fluid\"\ndensity = \"800 kg/m^3\"\n"
              "viscosity = \"1 Pa*s\"\n[flow]");
}

TEST(TwoFluids, ShareTheChannelWithoutAGap) {
    const ParticleSet between = mesh_texts(two_fluids("1")).particles;
    EXPECT_EQ(count_of(between, "water"), 32U * 8);
    EXPECT_EQ(count_of(between, "oil"), 32U * 8);
    EXPECT_EQ(count_of(between, "wall"), 32U * 6);
    // A row of points exactly on the border goes to the first fluid.
    const ParticleSet on_border = mesh_texts(two_fluids("1.0625")).particles;
    EXPECT_EQ(count_of(on_border, "water"), 32U * 9);
    EXPECT_EQ(count_of(on_border, "oil"), 32U * 7);
    EXPECT_EQ(count_of(on_border, "wall"), 32U * 6);
    EXPECT_EQ(smallest_distance(on_border), 1);
    for (std::size_t i = 0; i < on_border.size(); ++i)
        if (on_border.parts[on_border.part[i]].name == "oil") {
            EXPECT_EQ(on_border.mass[i], 800.0 / 64);
        }
}

TEST(TwoFluids, MayShareACurvedBorder) {
    // The chords of the drop's edge slope in all ways: their middles are not on it to the last bit.
    const Texts drop = channel
                           .with("Plane Surface(1) = {1};",
                                 "Point(10) = {2, 1, 0};\nPoint(11) = {2.6, 1.1, 0};\nPoint(12) = {1.9, 1.6, 0};\n"
                                 "Point(13) = {1.4, 0.9, 0};\nPoint(14) = {2.1, 0.4, 0};\n"
                                 "Circle(11) = {11, 10, 12};\nCircle(12) = {12, 10, 13};\nCircle(13) = {13, 10, 14};\n"
                                 "Circle(14) = {14, 10, 11};\nCurve Loop(2) = {11:14};\nPlane Surface(1) = {1, 2};\n"
                                 "Plane Surface(2) = {2};")
                           .with("Physical Curve", "Physical Surface(\"oil\") = {2};\nPhysical Curve")
                           .with("[flow]",
                                 "[[part]]\nname = \"oil\"\nkind = \"fluid\"\ndensity = \"800 kg/m^3\"\n"
                                 "viscosity = \"1 Pa*s\"\n[flow]");
    const ParticleSet set = mesh_texts(drop).particles;
    EXPECT_EQ(count_of(set, "water") + count_of(set, "oil"), 32U * 16);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        const double radius = (set.position[i] - Vec(2, 1, 0)).norm();
        const bool oil = set.parts[set.part[i]].name == "oil";
        EXPECT_TRUE(oil ? radius < 0.609 : radius > 0.607) << set.position[i].transpose();  // sqrt(0.37) less chords
    }
}

TEST(PeriodicInBothAxes, HasNoWalls) {
    const Texts texts = channel.with("[\"x\"]", "[\"x\", \"y\"]")
                            .with("[[part]]\nname = \"wall\"\nkind = \"rigid\"\n", "")
                            .with("Physical Curve(\"wall\") = {1, 3};\n", "");
    const Meshed meshed = mesh_texts(texts);
    EXPECT_EQ(meshed.particles.size(), 32U * 16);
    EXPECT_EQ(meshed.particles.box.high, Vec(4, 2, 0));
    EXPECT_NEAR(meshed.report.parts[0].kernel_sum_mean, 1.00514234077735619, 1e-12);
    EXPECT_NEAR(meshed.report.parts[0].kernel_sum_spread, 0, 1e-7);
}

}  // namespace
}  // namespace dmp::tests::small_meshes_tests
