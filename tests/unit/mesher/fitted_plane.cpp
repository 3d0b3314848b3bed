// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Particles that follow the curves of a geometry in 2-D.
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "mesher/inspect.hpp"
#include "mesher/searchable_particles.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::fitted_plane_tests {
namespace {

MeshReport inspected(const Meshed& meshed) {
    MeshResult result{meshed.particles, meshed.report, {}};
    result.kernel_sum.resize(result.particles.size());
    inspect(result, meshed.geometry, meshed.scene);
    return result.report;
}

const MeshReport::PartLine& line_of(const MeshReport& report, const std::string& part) {
    return *std::ranges::find(report.parts, part, &MeshReport::PartLine::name);
}

/// What every relaxed mesh is held to.
void expect_a_good_fit(const Meshed& meshed, const std::string& fluid) {
    const MeshReport report = inspected(meshed);
    const auto& line = line_of(report, fluid);
    for (const auto& surface : report.surfaces) {
        EXPECT_LT(surface.from_particles.rms, 0.05) << surface.part;
        EXPECT_GT(surface.from_particles.positions, 0U);
    }
    EXPECT_NEAR(line.inside.mean, 1, 0.015) << "1.005 on a square lattice";
    EXPECT_LT(line.inside.spread, 0.01);
    EXPECT_LT(line.near_walls.spread, 0.03);
    if (line.near_walls.particles > 0) {
        EXPECT_NEAR(line.near_walls.mean, 1, 0.02);
    }
    EXPECT_GT(line.nearest, 0.75);
    EXPECT_LT(std::abs(line.volume_error()), 0.01);
    ASSERT_TRUE(report.leaks);
    EXPECT_EQ(report.leaks->particles, 0U);
    EXPECT_THAT(report.notes, testing::Contains(testing::HasSubstr("relaxed in ")));
}

/// As if fill = "relaxed" stood in it, on a lattice that fits neither the period nor the walls; or "sampled".
Texts relaxed(const Texts& texts, const std::string& start) {
    const std::string fill =
        start == "sampled" ? "fill = \"sampled\"" : "fill = \"relaxed\"\narrangement = \"" + start + "\"";
    return texts.with("spacing = \"0.125 m\"", "spacing = \"0.0437 m\"\n" + fill);
}

/// The channel with a round island.
const Texts island = channel
                         .with("Plane Surface(1) = {1};",
                               "Point(10) = {2, 1, 0};\nPoint(11) = {2.5, 1, 0};\nPoint(12) = {2, 1.5, 0};\n"
                               "Point(13) = {1.5, 1, 0};\nPoint(14) = {2, 0.5, 0};\n"
                               "Circle(11) = {11, 10, 12};\nCircle(12) = {12, 10, 13};\nCircle(13) = {13, 10, 14};\n"
                               "Circle(14) = {14, 10, 11};\nCurve Loop(2) = {11:14};\nPlane Surface(1) = {1, 2};")
                         .with("Physical Curve(\"wall\") = {1, 3}", "Physical Curve(\"wall\") = {1, 3, 11:14}");

class FittedIsland : public testing::TestWithParam<const char*> {};

TEST_P(FittedIsland, is_followed_on_both_sides) {
    const Meshed meshed = mesh_texts(relaxed(island, GetParam()));
    expect_a_good_fit(meshed, "water");
    const ParticleSet& set = meshed.particles;
    double volume = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double d = ((set.position[i] - Vec(2, 1, 0)).norm() - 0.5) / set.spacing;
        if (set.kind(i) == PartKind::fluid) {
            EXPECT_GT(d, 0.45);
            volume += set.volume[i];
            continue;
        }
        EXPECT_LT(set.wall_distance[i], 3 * set.spacing);
        if (set.position[i].y() < 0 || set.position[i].y() > 2) continue;
        EXPECT_LT(d, -0.45);
        EXPECT_NEAR(set.wall_distance[i], -d * set.spacing, 2e-3 * set.spacing);  // how far chords are from the circle
        EXPECT_GT(set.wall_normal[i].dot((set.position[i] - Vec(2, 1, 0)).normalized()), 0.99);
    }
    EXPECT_NEAR(volume, 8 - 0.25 * std::numbers::pi, 1e-3) << "less what chords cut off";
    EXPECT_NEAR(line_of(meshed.report, "water").volume_error(), 0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(From, FittedIsland, testing::Values("square", "hexagonal", "sampled"),
                         [](const auto& start) { return std::string(start.param); });

/// The island cut by the periodic sides, and the half of it on a plane of symmetry: as good as whole.
TEST(FittedInPlane, goes_on_across_periodic_sides) {
    const Texts halves =
        channel
            .with(
                "Line(2) = {2, 3};",
                "Point(5) = {4, 0.5, 0};\nPoint(6) = {3.5, 1, 0};\nPoint(7) = {4, 1.5, 0};\nPoint(8) = {4, 1, 0};\n"
                "Point(9) = {0, 1.5, 0};\nPoint(10) = {0.5, 1, 0};\nPoint(11) = {0, 0.5, 0};\nPoint(12) = {0, 1, 0};\n"
                "Line(2) = {2, 5};\nCircle(5) = {5, 8, 6};\nCircle(6) = {6, 8, 7};\nLine(7) = {7, 3};\n"
                "Line(8) = {4, 9};\nCircle(9) = {9, 12, 10};\nCircle(10) = {10, 12, 11};\n")
            .with("Line(4) = {4, 1};", "Line(4) = {11, 1};")
            .with("Curve Loop(1) = {1, 2, 3, 4};", "Curve Loop(1) = {1, 2, 5, 6, 7, 3, 8, 9, 10, 4};")
            .with("Physical Curve(\"wall\") = {1, 3}", "Physical Curve(\"wall\") = {1, 3, 5, 6, 9, 10}");
    for (const char* start : {"hexagonal", "sampled"}) {
        const Meshed meshed = mesh_texts(relaxed(halves, start));
        expect_a_good_fit(meshed, "water");
        const ParticleSet& set = meshed.particles;
        for (std::size_t i = 0; i < set.size(); ++i) {
            EXPECT_GE(set.position[i].x(), 0);
            EXPECT_LT(set.position[i].x(), 4);
            const double x = std::min(set.position[i].x(), 4 - set.position[i].x());
            const double d = (std::hypot(x, set.position[i].y() - 1) - 0.5) / set.spacing;
            if (set.kind(i) == PartKind::fluid) {
                EXPECT_GT(d, 0.45);
            }
        }
    }
}

TEST(FittedInPlane, goes_on_behind_planes_of_symmetry) {
    const Texts half = channel
                           .with("Line(1) = {1, 2};",
                                 "Point(5) = {1.5, 0, 0};\nPoint(6) = {2, 0.5, 0};\nPoint(7) = {2.5, 0, 0};\n"
                                 "Point(8) = {2, 0, 0};\nLine(1) = {1, 5};\nCircle(5) = {5, 8, 6};\n"
                                 "Circle(6) = {6, 8, 7};\nLine(7) = {7, 2};")
                           .with("Curve Loop(1) = {1, 2, 3, 4};", "Curve Loop(1) = {1, 5, 6, 7, 2, 3, 4};")
                           .with("Physical Curve(\"wall\") = {1, 3}", "Physical Curve(\"wall\") = {3, 5, 6}")
                           .with("periodic = [\"x\"]", "periodic = [\"x\"]\nsymmetry = [\"y_low\"]");
    for (const char* start : {"hexagonal", "sampled"}) {
        const Meshed meshed = mesh_texts(relaxed(half, start));
        expect_a_good_fit(meshed, "water");
        const ParticleSet& set = meshed.particles;
        for (const Vec& position : set.position) EXPECT_GE(position.y(), 0) << "nothing beyond the plane";
    }
}

TEST(FittedInPlane, fluids_end_at_each_other) {
    const Texts drop = island.with("Plane Surface(1) = {1, 2};", "Plane Surface(1) = {1, 2};\nPlane Surface(2) = {2};")
                           .with("Physical Curve(\"wall\") = {1, 3, 11:14}",
                                 "Physical Surface(\"oil\") = {2};\nPhysical Curve(\"wall\") = {1, 3}")
                           .with("[flow]",
                                 "[[part]]\nname = \"oil\"\nkind = \"fluid\"\ndensity = \"800 kg/m^3\"\n"
                                 "viscosity = \"1 Pa*s\"\n[flow]");
    for (const char* start : {"square", "sampled"}) {
        const Meshed meshed = mesh_texts(relaxed(drop, start));
        expect_a_good_fit(meshed, "water");
        expect_a_good_fit(meshed, "oil");
        const ParticleSet& set = meshed.particles;
        for (std::size_t i = 0; i < set.size(); ++i) {
            if (set.kind(i) != PartKind::fluid) continue;
            const double d = ((set.position[i] - Vec(2, 1, 0)).norm() - 0.5) / set.spacing;
            const bool oil = set.parts[static_cast<std::size_t>(set.part[i])].name == "oil";
            EXPECT_GT(oil ? -d : d, 0.45) << set.position[i].transpose();
        }
    }
}

TEST(FittedInPlane, leaflets_stay_where_they_are) {
    const Meshed lattice = mesh_case("vein_valve", {"particles.spacing=0.2 mm"});
    const Meshed meshed = mesh_case("vein_valve", {"particles.spacing=0.2 mm", "particles.fill=relaxed"});
    expect_a_good_fit(meshed, "blood");
    const ParticleSet& set = meshed.particles;
    EXPECT_EQ(set.bonds.size(), lattice.particles.bonds.size());
    const SearchableParticles search(set, set.spacing);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::elastic) continue;
        EXPECT_EQ(set.position[i], lattice.particles.position[i]);
        search.for_each_neighbour(i, [&](std::size_t j, const Vec& apart) {
            if (set.kind(j) == PartKind::fluid) {
                EXPECT_GT(apart.norm(), 0.8 * set.spacing);
            }
        });
    }
    const CurveSet& leaflets = *meshed.geometry.curve_set("leaflets");
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::fluid) {
            ASSERT_GT(leaflets.nearest(set.position[i]).distance, 0.8 * set.spacing) << "none went in between";
        }
}

TEST(FittedInPlane, refuses_disorder) {
    EXPECT_EQ(
        fault_of(channel.with("spacing = \"0.125 m\"", "spacing = \"0.125 m\"\nfill = \"relaxed\"\ndisorder = 0.1")),
        "scene.toml:7:12: particles.disorder displaces particles from a lattice, which particles.fill = "
        "\"relaxed\" does not keep\n"
        "  leave out disorder or fill");
}

}  // namespace
}  // namespace dmp::tests::fitted_plane_tests
