// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/spring_lattice.hpp"

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "models/sph/kernels.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::spring_lattice_tests {
namespace {

Part part_with(double bending, double axial, bool lower) {
    Part part;
    part.name = std::string("leaflets");
    part.bending_stiffness = bending;
    part.axial_stiffness = Value<double>(axial, {"scene.toml", 31, 19});
    part.lower_axial_stiffness = lower;
    return part;
}

TEST(LadderConstants, GiveTheStiffnessesAskedFor) {
    for (const double along : {1.0e-4, 0.97e-4, 1.06e-4}) {
        const double across = 1e-4, bending = 3e-6, axial = 100;
        const LadderConstants ladder = ladder_constants(part_with(bending, axial, true), along, across);
        EXPECT_NEAR(ladder.axial_stiffness() / axial, 1, 1e-14);
        EXPECT_NEAR(ladder.bending_stiffness() / bending, 1, 1e-14);
        // k_b = EA / (4 a), k_a = (EI - EA b^2/4) / (2 a), GA_s = 8 k_a / a
        EXPECT_NEAR(ladder.bond_stiffness * 4 * along / 100, 1, 1e-14);
        EXPECT_NEAR(ladder.hinge_stiffness * 2 * along / (3e-6 - 2.5e-7), 1, 1e-14);
        EXPECT_NEAR(ladder.shear_stiffness() * along * along / (4 * (3e-6 - 2.5e-7)), 1, 1e-14);
        EXPECT_EQ(ladder.along, along);
        EXPECT_EQ(ladder.across, across);
    }
}

TEST(LadderConstants, LowerTheAxialStiffnessToHalfOfTheBending) {
    const Part part = part_with(3e-6, 100, true);
    const LadderConstants coarse = ladder_constants(part, 4e-4, 4e-4);
    EXPECT_NEAR(coarse.axial_stiffness(), 2 * 3e-6 / square(4e-4), 1e-12);  // 37.5 N
    EXPECT_NEAR(coarse.bending_stiffness() / 3e-6, 1, 1e-14);
    EXPECT_NEAR(coarse.hinge_stiffness * 2 * 4e-4, 1.5e-6, 1e-20);
    // Exactly a half is still as asked.
    EXPECT_NEAR(ladder_constants(part_with(3e-6, 37.5, true), 4e-4, 4e-4).axial_stiffness(), 37.5, 1e-12);
}

TEST(LadderConstants, KeepTheAxialStiffnessWhereItMayNotBeLowered) {
    const LadderConstants ladder = ladder_constants(part_with(3e-6, 70, false), 4e-4, 4e-4);  // share 0.93
    EXPECT_NEAR(ladder.axial_stiffness(), 70, 1e-12);
    EXPECT_NEAR(ladder.bending_stiffness() / 3e-6, 1, 1e-14);
    EXPECT_GT(ladder.hinge_stiffness, 0);
}

TEST(LadderConstants, RefuseNegativeHinges) {
    try {
        (void)ladder_constants(part_with(3e-6, 100, false), 4e-4, 4e-4);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "scene.toml:31:19: the hinges of 'leaflets' would need a negative stiffness, -0.00125 J: two rows "
                     "0.0004 m apart with axial_stiffness 100 N alone bend with EI = 4e-06 N*m^2, more than "
                     "bending_stiffness 3e-06 N*m^2\n"
                     "  lower axial_stiffness to at most 75 N, refine particles.spacing, or set "
                     "lower_axial_stiffness = true");
    }
}

TEST(LadderConstants, CrossBondsGiveTheStiffnessesAskedFor) {
    const double across = 1e-4, bending = 3e-6;
    for (const double along : {1.0e-4, 0.97e-4, 1.06e-4})
        for (const double axial : {1800.0, 4000.0}) {  // 4 EI / b^2 = 1200
            Part part = part_with(bending, axial, true);
            part.cross_bonds = true;
            const LadderConstants ladder = ladder_constants(part, along, across);
            EXPECT_NEAR(ladder.axial_stiffness() / axial, 1, 1e-13);
            EXPECT_NEAR(ladder.bending_stiffness() / bending, 1, 1e-14);
            EXPECT_EQ(ladder.hinge_stiffness, 0);
            EXPECT_EQ(ladder.rung_stiffness, ladder.cross_stiffness);
        }
    LadderConstants equal;
    equal.bond_stiffness = equal.cross_stiffness = equal.rung_stiffness = equal.along = equal.across = 1;
    EXPECT_DOUBLE_EQ(equal.axial_stiffness(), 5);
    EXPECT_DOUBLE_EQ(equal.bending_stiffness(), 1);
    EXPECT_DOUBLE_EQ(equal.shear_stiffness(), 2);
}

TEST(LadderConstants, CrossBondsRaiseTheAxialStiffnessOrRefuse) {
    Part part = part_with(3e-6, 100, true);
    part.cross_bonds = true;
    const LadderConstants raised = ladder_constants(part, 1e-4, 1e-4);
    EXPECT_NEAR(raised.axial_stiffness(), 5 * 3e-6 / 1e-8, 1e-9);
    EXPECT_NEAR(raised.bending_stiffness() / 3e-6, 1, 1e-14);
    EXPECT_EQ(raised.cross_stiffness, raised.bond_stiffness);
    part.lower_axial_stiffness = false;
    try {
        (void)ladder_constants(part, 1e-4, 1e-4);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "scene.toml:31:19: the cross bonds of 'leaflets' would need a stiffness of -1.1e+07 N/m: two rows "
                     "0.0001 m apart that bend with EI = 3e-06 N*m^2 alone have EA = 1200 N, more than axial_stiffness "
                     "100 N\n"
                     "  set cross_bonds = false, or lower_axial_stiffness = true, which here raises EA");
    }
}

TEST(LadderConstants, GiveTheShearStiffnessAskedForToo) {
    // At a = b: hinges alone have GA = 4 EI / b^2 - EA, so more needs diagonals.
    for (const double along : {1.0e-4, 0.97e-4, 1.06e-4})
        for (const double shear : {1150.0, 400.0, 80.0}) {
            Part part = part_with(3e-6, 1200, false);
            part.shear_stiffness = Value<double>(shear, {"scene.toml", 32, 19});
            const LadderConstants ladder = ladder_constants(part, along, 1e-4);
            EXPECT_NEAR(ladder.axial_stiffness() / 1200, 1, 1e-12) << shear;
            EXPECT_NEAR(ladder.bending_stiffness() / 3e-6, 1, 1e-13) << shear;
            EXPECT_NEAR(ladder.shear_stiffness() / shear, 1, 1e-13);
            EXPECT_GT(ladder.cross_stiffness, 0);
            EXPECT_GT(ladder.hinge_stiffness, 0);
            EXPECT_EQ(ladder.rung_stiffness, ladder.bond_stiffness);
        }
}

TEST(LadderConstants, KeepTheShearStiffnessWhereTheAxialOneIsOutOfRangeOrRefuse) {
    Part part = part_with(3e-6, 100, true);
    part.shear_stiffness = Value<double>(200.0, {"scene.toml", 32, 19});
    const LadderConstants raised = ladder_constants(part, 1e-4, 1e-4);
    EXPECT_NEAR(raised.axial_stiffness(), 4 * 3e-6 / 1e-8 - 200, 1e-9);
    EXPECT_NEAR(raised.shear_stiffness(), 200, 1e-10);
    EXPECT_EQ(raised.cross_stiffness, 0);
    part.axial_stiffness = 5000.0;
    const LadderConstants lowered = ladder_constants(part, 1e-4, 1e-4);
    EXPECT_EQ(lowered.hinge_stiffness, 0);
    EXPECT_NEAR(lowered.shear_stiffness(), 200, 1e-10);
    EXPECT_LT(lowered.axial_stiffness(), 5000);
    EXPECT_NEAR(lowered.bending_stiffness() / 3e-6, 1, 1e-14);
    part.lower_axial_stiffness = false;
    EXPECT_EQ(text_thrown<InputError>([&] { (void)ladder_constants(part, 1e-4, 1e-4); }).substr(0, 109),
              "scene.toml:32:19: part 'leaflets': two rows 0.0001 m apart with EI = 3e-06 N*m^2 and GA = 200 N have EA "
              "= 100");
}

TEST(StripStiffness, FollowsFromTheMaterial) {
    Part part;
    part.youngs_modulus = 2e6;
    part.thickness = 0.02;
    EXPECT_DOUBLE_EQ(strip_stiffness(part).axial, 4e4);
    EXPECT_DOUBLE_EQ(strip_stiffness(part).bending, 2e6 * 8e-6 / 12);
    part.poisson_ratio = 0.3975;
    EXPECT_DOUBLE_EQ(strip_stiffness(part).axial, 4e4 / (1 - 0.3975 * 0.3975));
    EXPECT_DOUBLE_EQ(strip_stiffness(part).bending, 4e4 / (1 - 0.3975 * 0.3975) * 4e-4 / 12);
    const StripStiffness as_given = strip_stiffness(part_with(3, 100, true));
    EXPECT_EQ(as_given.bending, 3);
    EXPECT_EQ(as_given.axial, 100);
}

TEST(LadderAlong, AStraightCurve) {
    const Polyline line{{Vec(1, 2, 0), Vec(1, 3, 0)}, false};
    const Ladder ladder = ladder_along(line, 0.125, {2, 0.125});
    ASSERT_EQ(ladder.columns(), 9);
    EXPECT_EQ(ladder.along, 0.125);
    for (int c = 0; c < 9; ++c) {  // left of a line that runs up is -x
        const std::size_t left = 2 * static_cast<std::size_t>(c);
        EXPECT_EQ(ladder.nodes[left], Vec(1 - 0.0625, 2 + 0.125 * c, 0));
        EXPECT_EQ(ladder.nodes[left + 1], Vec(1 + 0.0625, 2 + 0.125 * c, 0));
    }
}

TEST(LadderAlong, OfHalfACellMoreHasAsManyColumnsWhereverItStands) {
    for (int k = 0; k < 200; ++k) {
        const Vec from(0.001 * k * k, -0.077 * k, 0), along(std::cos(0.1 * k), std::sin(0.1 * k), 0);
        EXPECT_EQ(ladder_along({{from, from + 0.01 * along}, false}, 0.0008, {2, 0.0008}).columns(), 13 + 1) << k;
    }
}

TEST(LadderAlong, ColumnsFitTheLength) {
    const Polyline line{{Vec(0, 0, 0), Vec(1.07, 0, 0)}, false};
    for (const auto& [spacing, cells] : {std::pair{0.1, 11}, std::pair{0.103, 10}, std::pair{5.0, 1}}) {
        const Ladder ladder = ladder_along(line, spacing, {2, spacing});
        EXPECT_EQ(ladder.columns(), cells + 1);
        EXPECT_DOUBLE_EQ(ladder.along, 1.07 / cells);
        EXPECT_NEAR(ladder.nodes.back()[0], 1.07, 1e-15);
        EXPECT_DOUBLE_EQ(ladder.nodes.back()[1], -0.5 * spacing);
    }
}

TEST(LadderAlong, ACircleHasAShorterInnerRow) {
    constexpr double pi = std::numbers::pi, radius = 2, spacing = 0.1;
    Polyline arc;
    for (int k = 0; k <= 3000; ++k)
        arc.points.emplace_back(radius * std::cos(k * pi / 6000), radius * std::sin(k * pi / 6000), 0);
    const Ladder ladder = ladder_along(arc, spacing, {2, spacing});
    ASSERT_EQ(ladder.columns(), 32);  // 31.4 cells
    EXPECT_NEAR(ladder.along, pi / 31, 1e-6);
    for (int c = 0; c < 32; ++c) {
        const std::size_t left = 2 * static_cast<std::size_t>(c);
        const Vec& inner = ladder.nodes[left];  // the arc turns left
        const Vec& outer = ladder.nodes[left + 1];
        EXPECT_NEAR(inner.norm(), radius - spacing / 2, 1e-6);
        EXPECT_NEAR(outer.norm(), radius + spacing / 2, 1e-6);
        EXPECT_NEAR((outer - inner).norm(), spacing, 1e-15);
        EXPECT_NEAR(std::atan2(inner[1], inner[0]), c * pi / 62, 1e-3);
    }
}

/// Elastic energy of the springs, as particles/particle_set.hpp defines it.
double energy(const ParticleSet& set, const std::vector<Vec>& position) {
    double sum = 0;
    for (const Bond& bond : set.bonds)
        sum += bond.stiffness * square((position[bond.a] - position[bond.b]).norm() - bond.rest_length);
    for (const Hinge& hinge : set.hinges) {
        const Vec a = position[hinge.a] - position[hinge.centre], b = position[hinge.b] - position[hinge.centre];
        const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
        sum += hinge.stiffness * square(std::remainder(angle - hinge.rest_angle, 2 * std::numbers::pi));
    }
    return sum;
}

/// Positions of a flap's nodes moved by `move(along the flap, to its right)`, both measured from its root.
template <class Move>
std::vector<Vec> moved(const ParticleSet& set, const Move& move) {
    std::vector<Vec> positions;
    for (std::size_t i = 0; i < set.size(); ++i)
        positions.push_back(set.kind(i) == PartKind::elastic ? move(set.position[i][1], set.position[i][0] - 2)
                                                             : set.position[i]);
    return positions;
}

TEST(LadderEnergy, IsThatOfTheBeamAskedFor) {
    const auto meshed = mesh_texts(flap_channel);
    const ParticleSet& set = meshed.particles;
    ASSERT_EQ(meshed.report.springs.size(), 1U);
    const auto& line = meshed.report.springs[0];
    EXPECT_NEAR(line.axial_stiffness, 100, 1e-10);
    EXPECT_NEAR(line.bending_stiffness, 3, 1e-12);
    EXPECT_NEAR(energy(set, set.position), 0, 1e-20);
    EXPECT_NEAR(
        energy(set, moved(set, [](double s, double t) { return Vec(5 - 0.6 * s + 0.8 * t, 0.8 * s + 0.6 * t, 0); })), 0,
        1e-20);  // rigid motion

    const double length = 1, small = 1e-4;
    const double stretch = energy(set, moved(set, [&](double s, double t) { return Vec(t, s * (1 + small), 0); }));
    EXPECT_NEAR(stretch / (0.5 * 100 * small * small * length), 1, 1e-9);

    const double radius = length / small;
    const double bending =
        energy(set, moved(set, [&](double s, double t) {
                   return Vec((radius + t) * std::cos(s / radius), (radius + t) * std::sin(s / radius), 0);
               }));
    EXPECT_NEAR(bending / (0.5 * 3 * length / square(radius)), 1, 1e-4);

    const double shear = energy(set, moved(set, [&](double s, double t) { return Vec(t + small * s, s, 0); }));
    EXPECT_NEAR(shear / (0.5 * line.shear_stiffness * small * small * length), 1, 1e-4);
}

TEST(LadderEnergy, OfAThickStripIsThatOfItsMaterial) {
    for (const auto& [thickness, rows] : {std::pair{0.375, 3}, std::pair{0.5, 4}, std::pair{0.7, 6}}) {
        std::ostringstream material;
        material << "youngs_modulus = \"1 kPa\"\nthickness = \"" << thickness << " m\"";
        const auto meshed = mesh_texts(
            flap_channel.with("bending_stiffness = \"3 N*m^2\"\naxial_stiffness = \"100 N\"", material.str()));
        const ParticleSet& set = meshed.particles;
        ASSERT_EQ(set.count(PartKind::elastic), 9U * static_cast<std::size_t>(rows));
        EXPECT_NEAR(energy(set, set.position), 0, 1e-20);
        const double length = 1, small = 1e-4, radius = length / small, axial = 1e3 * thickness;
        const double stretch = energy(set, moved(set, [&](double s, double t) { return Vec(t, s * (1 + small), 0); }));
        EXPECT_NEAR(stretch / (0.5 * axial * small * small * length), 1, 1e-9) << rows;
        const double bending =
            energy(set, moved(set, [&](double s, double t) {
                       return Vec((radius + t) * std::cos(s / radius), (radius + t) * std::sin(s / radius), 0);
                   }));
        EXPECT_NEAR(bending / (0.5 * axial * square(thickness) / 12 * length / square(radius)), 1, 1e-4) << rows;
        // With columns as far apart as rows a third of EA: near the 5/6 G A = 0.42 EA of a material with nu = 0.
        const double shear = energy(set, moved(set, [&](double s, double t) { return Vec(t + small * s, s, 0); }));
        const double rows_apart = thickness / rows, expected = axial * square(rows_apart / 0.125) / 3;
        EXPECT_NEAR(shear / (0.5 * expected * small * small * length), 1, 1e-4) << rows;
        EXPECT_NEAR(meshed.report.springs[0].shear_stiffness / expected, 1, 1e-9) << rows;
    }
}

TEST(LadderEnergy, WithAShearStiffnessIsThatAskedFor) {
    Texts texts = flap_channel;
    const double spacing = mesh_texts(texts).particles.spacing;
    const double shear_stiffness = 0.5 / square(spacing);
    std::ostringstream with_shear;
    with_shear << "axial_stiffness = \"" << 12 / square(spacing) << " N\"\nshear_stiffness = \"" << shear_stiffness
               << " N\"";
    const std::string without = "axial_stiffness = \"100 N\"";
    texts.scene.replace(texts.scene.find(without), without.size(), with_shear.str());
    const auto meshed = mesh_texts(texts);
    const ParticleSet& set = meshed.particles;
    const auto& line = meshed.report.springs[0];
    EXPECT_GT(set.hinges.size(), 0U);
    EXPECT_GT(line.cross_stiffness, 0);
    EXPECT_NEAR(line.axial_stiffness * square(spacing) / 12, 1, 1e-5);
    EXPECT_NEAR(line.shear_stiffness / shear_stiffness, 1, 1e-5);
    EXPECT_THAT(meshed.report.text(),
                ::testing::AllOf(::testing::HasSubstr("across, "), ::testing::HasSubstr(" hinges of")));
    const double length = 1, small = 1e-4, radius = length / small;
    const double bending =
        energy(set, moved(set, [&](double s, double t) {
                   return Vec((radius + t) * std::cos(s / radius), (radius + t) * std::sin(s / radius), 0);
               }));
    EXPECT_NEAR(bending / (0.5 * 3 * length / square(radius)), 1, 1e-3);
    const double shear = energy(set, moved(set, [&](double s, double t) { return Vec(t + small * s, s, 0); }));
    EXPECT_NEAR(shear / (0.5 * shear_stiffness * small * small * length), 1, 1e-3);
}

TEST(LadderEnergy, OfAMaterialWithCrossBondsIsThatOfTheBeamAskedFor) {
    // h = 0.6 spacings: EA = 1000 N lies above 5 EI / spacing^2.
    Texts texts = flap_channel;
    const std::string as_strip = "bending_stiffness = \"3 N*m^2\"\naxial_stiffness = \"100 N\"\n";
    const auto at = texts.scene.find(as_strip);
    ASSERT_NE(at, std::string::npos);
    const auto spacing = mesh_texts(texts).particles.spacing;
    std::ostringstream material;
    material << "youngs_modulus = \"" << 1000 / (0.6 * spacing) << " Pa\"\nthickness = \"" << 0.6 * spacing
             << " m\"\ncross_bonds = true\n";
    texts.scene.replace(at, as_strip.size(), material.str());
    const auto meshed = mesh_texts(texts);
    const ParticleSet& set = meshed.particles;
    const auto& line = meshed.report.springs[0];
    const double bending_stiffness = 1000 * square(0.6 * spacing) / 12;
    EXPECT_NEAR(line.axial_stiffness / 1000, 1, 1e-5);
    EXPECT_NEAR(line.bending_stiffness / bending_stiffness, 1, 1e-5);
    EXPECT_TRUE(set.hinges.empty());
    EXPECT_GT(line.cross_stiffness, line.bond_stiffness);
    EXPECT_THAT(meshed.report.text(), ::testing::HasSubstr("along rows and k_c = "));
    const double length = 1, small = 1e-4, radius = length / small;
    const double bending =
        energy(set, moved(set, [&](double s, double t) {
                   return Vec((radius + t) * std::cos(s / radius), (radius + t) * std::sin(s / radius), 0);
               }));
    EXPECT_NEAR(bending / (0.5 * bending_stiffness * length / square(radius)), 1, 1e-3);
    const double shear = energy(set, moved(set, [&](double s, double t) { return Vec(t + small * s, s, 0); }));
    EXPECT_NEAR(shear / (0.5 * line.shear_stiffness * small * small * length), 1, 1e-3);
}

}  // namespace
}  // namespace dmp::tests::spring_lattice_tests
