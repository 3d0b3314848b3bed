// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>

#include "geometry/inside_test.hpp"
#include "geometry/nearest_curve.hpp"
#include "meshed_text.hpp"
#include "models/sph/kernels.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::case_meshes_tests {
namespace {

const MeshReport::PartLine& line_of(const Meshed& meshed, const std::string& part) {
    const auto& parts = meshed.report.parts;
    return *std::find_if(parts.begin(), parts.end(), [&](const auto& line) { return line.name == part; });
}

/// Indices of the particles of one kind.
std::vector<std::size_t> all_of(const ParticleSet& set, PartKind kind) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == kind) indices.push_back(i);
    return indices;
}

/// Smallest distance of any fluid particle to any wall or springs particle [spacings]; all cases are periodic in x.
double fluid_to_solids(const ParticleSet& set) {
    const double period = set.box.extent()[0];
    double smallest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : all_of(set, PartKind::fluid))
        for (std::size_t j = 0; j < set.size(); ++j) {
            if (set.kind(j) == PartKind::fluid) continue;
            Vec apart = set.position[i] - set.position[j];
            if (std::abs(apart[1]) > set.spacing) continue;
            apart[0] -= period * std::round(apart[0] / period);
            smallest = std::min(smallest, apart.squaredNorm());
        }
    return std::sqrt(smallest) / set.spacing;
}

void expect_a_sound_mesh(const Meshed& meshed, const std::string& fluid, int wall_layers = 3) {
    const ParticleSet& set = meshed.particles;
    const std::size_t size = set.size();
    for (const std::size_t entries :
         {set.volume.size(), set.mass.size(), set.part.size(), set.body.size(), set.fixed.size(), set.seated.size(),
          set.wall_normal.size(), set.wall_distance.size()})
        ASSERT_EQ(entries, size);
    const Region& region = *meshed.geometry.region(fluid);
    const InsideTest inside(region);
    const CurveSet& wall = *meshed.geometry.curve_set("wall");
    const double thickness = wall_layers * set.spacing;
    const NearestCurve surface(wall, 1.1 * thickness);
    const double period = set.box.extent()[0];
    for (std::size_t i = 0; i < size; ++i) {
        const Vec& point = set.position[i];
        ASSERT_GT(set.volume[i], 0);
        ASSERT_GT(set.mass[i], 0);
        ASSERT_GE(point[0], set.box.low[0]);
        ASSERT_LT(point[0], set.box.high[0]);
        if (set.kind(i) == PartKind::fluid) {
            ASSERT_EQ(inside.side_of(point), Side::inside) << point.transpose();
            ASSERT_EQ(set.fixed[i], 0);
            ASSERT_EQ(set.body[i], -1);
        }
        if (set.kind(i) == PartKind::elastic) {
            const SolidSurface at = set.surface(i);
            ASSERT_NEAR(at.normal.norm(), 1, 1e-12);
            // A strip's two rows stand half a spacing off its middle.
            ASSERT_NEAR((at.opposite - at.depth) / 2, set.spacing / 2, 0.02 * set.spacing);
            continue;
        }
        if (set.kind(i) != PartKind::rigid) {
            ASSERT_EQ(set.wall_normal[i], Vec(Vec::Zero()));
            ASSERT_EQ(set.wall_distance[i], 0);
            continue;
        }
        ASSERT_NE(inside.side_of(point), Side::inside) << point.transpose();
        ASSERT_EQ(set.fixed[i], 1);
        ASSERT_LT(set.wall_distance[i], thickness);
        ASSERT_NEAR(set.wall_normal[i].norm(), 1, 1e-12);
        // Across the normal lies the surface, and no surface is nearer: neither here nor across the period.
        double nearest = std::numeric_limits<double>::infinity(), foot = nearest;
        for (const double shift : {0.0, period, -period}) {
            const Vec moved = point + Vec(shift, 0, 0);
            if (const auto found = surface.nearest(moved)) nearest = std::min(nearest, found->distance);
            if (const auto found = surface.nearest(moved + set.wall_distance[i] * set.wall_normal[i]))
                foot = std::min(foot, found->distance);
        }
        ASSERT_NEAR(set.wall_distance[i], nearest, 1e-15);
        ASSERT_LT(foot, 1e-6 * set.spacing);
    }
    EXPECT_GT(fluid_to_solids(set), 0.75);
    EXPECT_NEAR(line_of(meshed, fluid).kernel_sum_mean, 1, 0.01);
    EXPECT_LT(line_of(meshed, fluid).kernel_sum_spread, 0.05);
    EXPECT_GT(line_of(meshed, fluid).nearest, 0.75);
    const double filled = static_cast<double>(line_of(meshed, fluid).particles) * square(set.spacing);
    EXPECT_NEAR(filled / line_of(meshed, fluid).target, 1, 0.01);
    for (const auto& part : meshed.report.parts) EXPECT_THAT(meshed.report.text(), testing::HasSubstr(part.name));
}

void expect_two_clamped_leaflets(const Meshed& meshed, std::size_t columns) {
    const ParticleSet& set = meshed.particles;
    std::array<std::size_t, 2> nodes{}, clamped{};
    std::set<int> bodies;
    for (const std::size_t i : all_of(set, PartKind::elastic)) {
        const auto body = static_cast<std::size_t>(set.body[i]);
        ASSERT_LT(body, 2U);
        ++nodes[body];
        if (set.fixed[i] == 0) continue;
        ++clamped[body];
        // Clamped nodes stand at the roots, one on each side of the leaflet.
        const auto& roots = meshed.geometry.points.at("leaflet_roots");
        const double root = std::min((set.position[i] - roots[0]).norm(), (set.position[i] - roots[1]).norm());
        EXPECT_NEAR(root, 0.5 * set.spacing, 1e-12);
    }
    EXPECT_THAT(nodes, testing::Each(2 * columns));
    EXPECT_THAT(clamped, testing::Each(2U));
    ASSERT_EQ(meshed.report.springs.size(), 1U);
    const auto& line = meshed.report.springs[0];
    EXPECT_EQ(line.bodies, 2);
    EXPECT_EQ(line.anchored, 4U);
    EXPECT_EQ(line.bonds, 2 * (columns + 2 * (columns - 1)));
    EXPECT_EQ(line.hinges, 2 * (4 * (columns - 1)));
    EXPECT_EQ(set.bonds.size(), line.bonds);
    EXPECT_EQ(set.hinges.size(), line.hinges);
    for (const Bond& bond : set.bonds) ASSERT_EQ(set.body[bond.a], set.body[bond.b]);
}

TEST(VeinValveMesh, AtItsOwnSpacing) {
    const Meshed meshed = mesh_case("vein_valve", {"particles.spacing=0.2 mm"});
    expect_a_sound_mesh(meshed, "blood");
    expect_two_clamped_leaflets(meshed, 89);  // 87.5 cells: 88
    const auto& set = meshed.particles;
    const double area = meshed.geometry.region("blood")->area();
    const double leaflets = 2 * 17.5e-3 * 2 * 0.2e-3;  // a leaflet and half a spacing more on each side
    EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)) * 4e-8 / (area - leaflets), 1, 0.005);
    EXPECT_NEAR(static_cast<double>(set.count(PartKind::rigid)) * 4e-8 /
                    (3 * 0.2e-3 * meshed.geometry.curve_set("wall")->length()),
                1, 0.03);
    double mass = 0;
    for (const std::size_t i : all_of(set, PartKind::elastic)) mass += set.mass[i];
    EXPECT_NEAR(mass / (0.42 * 2 * 17.5e-3), 1, 1e-12);
    EXPECT_EQ(set.periodic, (std::array{true, false, false}));
    EXPECT_EQ(set.box.low[0], -0.046);
    EXPECT_EQ(set.box.high[0], 0.046);
    EXPECT_LT(set.box.low[1], -0.007);
    EXPECT_GT(set.box.high[1], 0.007);
}

struct Published {
    std::string leaflet_length;
    double blood, leaflets;
};

TEST(VeinValveMesh, AtHalfTheSpacingHasTheParticlesOfThePublishedOnes) {
    for (const auto& [length, blood, leaflets] :
         {Published{"10 mm", 90012, 402}, Published{"17.5 mm", 89726, 702}, Published{"25.6 mm", 89592, 1026}}) {
        const Meshed meshed =
            mesh_case("vein_valve", {"particles.spacing=0.1 mm", "geometry.parameters.leaflet_length=" + length});
        const ParticleSet& set = meshed.particles;
        EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)) / blood, 1, 0.03) << length;
        EXPECT_NEAR(static_cast<double>(set.count(PartKind::elastic)) / leaflets, 1, 0.03) << length;
        EXPECT_NEAR(line_of(meshed, "blood").kernel_sum_mean, 1, 0.01);
        EXPECT_GT(line_of(meshed, "blood").nearest, 0.75);
        EXPECT_NEAR(meshed.report.springs.at(0).bending_stiffness / 3e-6, 1, 1e-12);
        EXPECT_NEAR(meshed.report.springs.at(0).axial_stiffness / 100, 1, 1e-12);
    }
}

TEST(VeinValveMesh, LongAndShortLeaflets) {
    const auto with_leaflets = [](const std::string& length) {
        return mesh_case("vein_valve", {"particles.spacing=0.2 mm", "geometry.parameters.leaflet_length=" + length});
    };
    const Meshed long_ones = with_leaflets("25.6 mm"), short_ones = with_leaflets("10 mm");
    expect_a_sound_mesh(long_ones, "blood");
    expect_two_clamped_leaflets(long_ones, 129);
    expect_a_sound_mesh(short_ones, "blood");
    expect_two_clamped_leaflets(short_ones, 51);
}

TEST(VeinValveMesh, BendsAlikeAtEverySpacing) {
    for (const std::string spacing : {"0.2", "0.4"}) {
        const Meshed meshed = mesh_case("vein_valve", {"particles.spacing=" + spacing + " mm"});
        const auto& line = meshed.report.springs.at(0);
        EXPECT_NEAR(line.bending_stiffness / 3e-6, 1, 1e-12) << spacing;
        EXPECT_NEAR(line.axial_stiffness / (spacing == "0.4" ? 37.5 : 100), 1, 1e-12) << spacing;
        EXPECT_EQ(line.axial_stiffness_asked, 100);
        const std::string note =
            "leaflets: EA lowered from 100 to 37.5 N, 37.5 % of that, so that two rows 0.0004 m apart can bend as "
            "softly as EI asks; "
            "EI "
            "is held";
        if (spacing == "0.4") {
            EXPECT_THAT(meshed.report.warnings, testing::Contains(note));
        } else {
            EXPECT_THAT(meshed.report.warnings, testing::Not(testing::Contains(testing::HasSubstr("EA lowered"))));
        }
    }
}

TEST(VeinValveMesh, WithoutItsLeaflets) {
    const Meshed meshed = mesh_case("vein_valve", {"particles.spacing=0.2 mm", "part.leaflets.enabled=false"});
    expect_a_sound_mesh(meshed, "blood");
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(set.count(PartKind::elastic), 0U);
    EXPECT_TRUE(set.bonds.empty());
    EXPECT_TRUE(set.hinges.empty());
    EXPECT_TRUE(meshed.report.springs.empty());
    EXPECT_TRUE(meshed.report.notes.empty());
    EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)) * 4e-8 / meshed.geometry.region("blood")->area(), 1,
                0.002);
}

TEST(VeinValveMesh, OnAHexagonalLattice) {
    const Meshed meshed = mesh_case("vein_valve", {"particles.spacing=0.2 mm", "particles.arrangement=hexagonal"});
    expect_a_sound_mesh(meshed, "blood");
    expect_two_clamped_leaflets(meshed, 89);
    // 92 mm / (0.2 mm sqrt(2 / sqrt 3)) = 428.078 columns: stretched to 428
    EXPECT_THAT(meshed.report.notes, testing::Contains(testing::HasSubstr("lattice stretched along x by 0.018279")));
}

TEST(BentChannelMesh, IsSoundOnAllArrangements) {
    for (const std::string arrangement : {"square", "hexagonal"}) {
        const Meshed meshed = mesh_case("bent_channel", {"particles.arrangement=" + arrangement});
        expect_a_sound_mesh(meshed, "blood");
        const auto& line = meshed.report.springs.at(0);
        EXPECT_EQ(line.bodies, 1);
        EXPECT_EQ(line.anchored, 2U);
        EXPECT_NEAR(line.bending_stiffness / 1e-6, 1, 1e-12);
    }
}

TEST(HeartValveMesh, AtHalfItsSpacing) {
    const Meshed meshed = mesh_case("heart_valve", {"particles.spacing=0.5 mm"});
    expect_a_sound_mesh(meshed, "blood", 4);
    expect_two_clamped_leaflets(meshed, 33);
    const auto& set = meshed.particles;
    const double area = meshed.geometry.region("blood")->area();
    const double leaflets = 2 * 16e-3 * 2 * 0.5e-3;
    EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)) * 0.25e-6 / (area - leaflets), 1, 0.005);
    EXPECT_EQ(set.box.low[0], -0.0525);
    EXPECT_EQ(set.box.high[0], 0.0525);
}

TEST(HeartValveMesh, AtAQuarterHasTheParticlesOfThePublishedOne) {
    const Meshed meshed =
        mesh_case("heart_valve", {"particles.spacing=0.25 mm", "geometry.parameters.leaflet_length=16.75 mm"});
    const ParticleSet& set = meshed.particles;
    EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)) / 49224, 1, 0.03);
    EXPECT_EQ(set.count(PartKind::elastic), 272U);
    EXPECT_NEAR(line_of(meshed, "blood").kernel_sum_mean, 1, 0.01);
    EXPECT_NEAR(meshed.report.springs.at(0).bending_stiffness / 3.0e-4, 1, 1e-12);
    EXPECT_NEAR(meshed.report.springs.at(0).axial_stiffness / 9600, 1, 1e-12);
}

TEST(DoubleVeinValveMesh, HasSoundPartsOnBothSidesOfItsWalls) {
    const Meshed meshed = mesh_case("double_vein_valve", {"particles.spacing=0.4 mm"});
    const ParticleSet& set = meshed.particles;
    EXPECT_GT(fluid_to_solids(set), 0.75);
    for (const std::string fluid : {"blood", "embolus", "tissue"}) {
        const auto& line = line_of(meshed, fluid);
        EXPECT_NEAR(line.kernel_sum_mean, 1, 0.01) << fluid;
        EXPECT_LT(line.kernel_sum_spread, 0.05) << fluid;
        EXPECT_GT(line.nearest, 0.75) << fluid;
        // The embolus is 13 spacings across, the tissue 7 deep above the chambers.
        EXPECT_NEAR(line.reached / line.target, 1, fluid == "blood" ? 0.01 : 0.03) << fluid;
    }
    ASSERT_EQ(meshed.report.springs.size(), 4U);
    for (const auto& line : meshed.report.springs) {
        EXPECT_EQ(line.bodies, 2);
        const bool leaflets = line.part.starts_with("leaflets");
        EXPECT_EQ(line.anchored, leaflets ? 4U : 8U) << line.part;
        EXPECT_NEAR(line.bending_stiffness / (leaflets ? 5e-6 : 4e-7), 1, 1e-12) << line.part;
        if (leaflets) {
            EXPECT_NEAR(line.axial_stiffness / 2500, 1, 1e-12);
        }
    }
    EXPECT_EQ(set.count(PartKind::elastic), 4U * 2 * (26 + 111));  // 10 mm and 44 mm of 0.4 mm, two rows
    // The shells are thick enough to keep blood and tissue out of each other's support.
    double nearest = std::numeric_limits<double>::infinity();
    const auto part_of = [&](std::size_t i) { return set.parts[set.part[i]].name; };
    for (const std::size_t i : all_of(set, PartKind::fluid))
        if (part_of(i) == "blood" && std::abs(set.position[i][0]) < 0.021 && set.position[i][1] > 3e-3)
            for (const std::size_t j : all_of(set, PartKind::fluid))
                if (part_of(j) == "tissue") nearest = std::min(nearest, (set.position[i] - set.position[j]).norm());
    EXPECT_GT(nearest, 3 * set.spacing);
}

TEST(DoubleVeinValveMesh, LeavesNoHoleBetweenALeafletsRootAndTheWallBeforeIt) {
    const ParticleSet set = mesh_case("double_vein_valve", {"particles.spacing=0.4 mm"}).particles;
    int roots = 0;
    for (const std::size_t node : all_of(set, PartKind::elastic)) {
        const Vec& root = set.position[node];
        if (set.fixed[node] == 0 || !set.parts[set.part[node]].name.starts_with("leaflets") || std::abs(root[1]) < 4e-3)
            continue;  // only nodes behind the wall's surface
        ++roots;
        double nearest = std::numeric_limits<double>::infinity();
        for (const std::size_t wall : all_of(set, PartKind::rigid))
            if (set.position[wall][0] < root[0]) nearest = std::min(nearest, (set.position[wall] - root).norm());
        EXPECT_LT(nearest, 0.75 * set.spacing) << "before the root at " << root.transpose();
    }
    EXPECT_EQ(roots, 4);
}

TEST(CiliaMesh, SixCellsToAPitch) {
    const Meshed meshed = mesh_case("cilia");
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(line_of(meshed, "pcl").particles, 36U * 4 * 54);  // 54 rows; two of six columns are the cilium's
    EXPECT_EQ(line_of(meshed, "mucus").particles, 36U * (6 * 22 - 2));
    for (const std::string fluid : {"pcl", "mucus"}) {
        EXPECT_NEAR(line_of(meshed, fluid).kernel_sum_mean, 1, 0.01) << fluid;
        EXPECT_LT(line_of(meshed, fluid).kernel_sum_spread, 0.005) << fluid;
        EXPECT_GT(line_of(meshed, fluid).nearest, 0.9) << fluid;
        EXPECT_LT(std::abs(line_of(meshed, fluid).volume_error()), 0.01) << fluid;
    }
    ASSERT_EQ(meshed.report.springs.size(), 1U);
    const auto& cilia = meshed.report.springs[0];
    EXPECT_EQ(cilia.bodies, 36);
    EXPECT_EQ(cilia.anchored, 36U * 2);
    EXPECT_EQ(set.count(PartKind::elastic), 36U * 2 * 55);
    EXPECT_NEAR(cilia.bending_stiffness / 1.32e-19, 1, 1e-12);
    EXPECT_NEAR(cilia.axial_stiffness / 2.64e-6, 1, 1e-12);
}

TEST(PoiseuilleMesh, HasTwentyRowsAndExactWalls) {
    const Meshed meshed = mesh_case("verification/poiseuille");
    expect_a_sound_mesh(meshed, "water");
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(set.count(PartKind::fluid), 20U * 8);
    EXPECT_EQ(set.count(PartKind::rigid), 2U * 3 * 8);
    EXPECT_TRUE(meshed.report.notes.empty());
    std::set<long> rows;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec& point = set.position[i];
        const double row = point[1] / 0.05e-3 - 0.5;
        ASSERT_NEAR(row, std::round(row), 1e-10);
        EXPECT_NEAR(set.volume[i], 2.5e-9, 1e-20);
        EXPECT_NEAR(set.mass[i], 2.5e-6, 1e-17);
        if (set.kind(i) == PartKind::fluid) {
            rows.insert(std::lround(row));
            continue;
        }
        const bool below = point[1] < 0;
        EXPECT_NEAR((set.wall_normal[i] - Vec(0, below ? 1 : -1, 0)).norm(), 0, 1e-12);
        EXPECT_NEAR(set.wall_distance[i], below ? -point[1] : point[1] - 1e-3, 1e-18);
    }
    EXPECT_EQ(rows.size(), 20U);
    EXPECT_EQ(*rows.begin(), 0);
    EXPECT_EQ(*rows.rbegin(), 19);
}

}  // namespace
}  // namespace dmp::tests::case_meshes_tests
