// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh's report says of it.
#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "bench/icosphere.hpp"
#include "meshed_text.hpp"
#include "mesher/inspect.hpp"
#include "mesher/leak_test.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::mesh_report_tests {
namespace {

const Texts duct{Texts(channel).with("schema = 1", "schema = 1\ndimension = 3").scene,
                 "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 2, 1, 1};\nPhysical Volume(\"water\") = {1};\n"
                 "Physical Surface(\"wall\") = {3, 4, 5, 6};\n"};

constexpr double radius_of_ball = 0.5065;  // 10.13 spacings of 0.05 m

/// The duct's scene without periods, with this lattice.
Texts ball_scene(const std::string& particles) {
    return Texts(duct).with("periodic = [\"x\"]\n", "").with("spacing = \"0.125 m\"", particles);
}

struct Inspected {
    MeshResult result;
    MeshDetail detail;
    [[nodiscard]] const MeshReport& report() const { return result.report; }
};

Inspected inspect_texts(const Texts& texts) {
    Meshed meshed = mesh_texts(texts);
    Inspected inspected{{std::move(meshed.particles), std::move(meshed.report), {}}, {}};
    inspected.detail = inspect(inspected.result, meshed.geometry, meshed.scene);
    return inspected;
}

/// A ball of fluid in a wall, without a detour over gmsh.
Inspected inspect_ball(const std::string& particles) {
    const Folder folder;
    Folder::write(ball_scene(particles).scene);
    const Scene scene = read_scene("scene.toml", {});
    Geometry geometry;
    geometry.dimension = 3;
    geometry.solids.push_back({"water", bench::icosphere(5, radius_of_ball)});
    geometry.surfaces.push_back({"wall", geometry.solids.front().surface});
    geometry.box = {Vec::Constant(-radius_of_ball), Vec::Constant(radius_of_ball)};
    Inspected inspected{mesh(geometry, scene), {}};
    inspected.detail = inspect(inspected.result, geometry, scene);
    return inspected;
}

/// The box from the origin to this corner, in twelve triangles.
TriangleSurface box_surface(const Vec& high) {
    TriangleSurface box;
    for (int k = 0; k < 8; ++k)
        box.corners.emplace_back((k & 1) != 0 ? high.x() : 0, (k & 2) != 0 ? high.y() : 0, (k & 4) != 0 ? high.z() : 0);
    box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return box;
}

/// The set without the particles that `drop` names.
ParticleSet without(const ParticleSet& set, const std::function<bool(std::size_t)>& drop) {
    ParticleSet kept;
    static_cast<ParticleSpace&>(kept) = set;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (drop(i)) continue;
        kept.position.push_back(set.position[i]);
        kept.part.push_back(set.part[i]);
    }
    return kept;
}

/// Walls' particles of a column along y, at this x (and z), nearer to y = 0 than `depth`.
std::function<bool(std::size_t)> column(const ParticleSet& set, const Vec& foot, double depth) {
    return [&set, foot, depth](std::size_t i) {
        const Vec apart = set.position[i] - foot;
        return set.kind(i) == PartKind::rigid && std::abs(apart.x()) < 1e-6 && std::abs(apart.z()) < 1e-6 &&
               apart.y() < 0 && apart.y() > -depth;
    };
}

void expect_an_exact_box(const Inspected& mesh, double farthest) {
    const MeshReport& report = mesh.report();
    const auto& water = report.parts.front();
    EXPECT_NEAR(water.volume_error(), 0, 1e-12);
    ASSERT_EQ(report.surfaces.size(), 1U);
    const auto& surface = report.surfaces.front();
    for (const auto& deviation : {surface.from_geometry, surface.from_particles}) {
        EXPECT_GE(deviation.positions, 64U);
        EXPECT_NEAR(deviation.rms, 0, 1e-9);
        EXPECT_NEAR(deviation.largest, 0, 1e-9);
    }
    EXPECT_LE(surface.farthest, farthest);
    EXPECT_GT(surface.farthest, 0.7 * farthest);
    ASSERT_TRUE(report.leaks);
    EXPECT_EQ(report.leaks->particles, 0U);
    EXPECT_GT(report.leaks->cells, 100U);
    ASSERT_EQ(report.layers.size(), 2U);
    EXPECT_EQ(report.layers[0].part, "water");
    EXPECT_EQ(report.layers[0].fewest, 5);
    EXPECT_EQ(report.layers[1].part, "wall");
    EXPECT_EQ(report.layers[1].fewest, 3);
    EXPECT_EQ(report.layers[1].mean, 3);
    // One bar at a spacing.
    for (const auto& part : report.parts)
        for (std::size_t bar = 0; bar < part.nearest_counts.size(); ++bar)
            EXPECT_EQ(part.nearest_counts[bar], bar == 50 ? part.particles : 0U);
    EXPECT_EQ(water.inside.particles + water.near_walls.particles, water.particles);
    EXPECT_NEAR(water.inside.mean, water.kernel_sum_mean, 1e-9);
    EXPECT_NEAR(water.near_walls.mean, water.kernel_sum_mean, 1e-9);
}

TEST(MeshReport, ABoxOnItsLatticeIsExactInThePlane) {
    const Inspected mesh = inspect_texts(channel);
    expect_an_exact_box(mesh, std::sqrt(0.5));
    // The wall is within a support of 2.6 spacings or more of at least two rows on each side.
    EXPECT_GE(mesh.report().parts[0].near_walls.particles, 4U * 32);
    std::size_t along = 0;
    for (const float error : mesh.detail.surface_error) along += std::isnan(error) ? 0 : 1;
    EXPECT_EQ(along, 2U * 32);
    EXPECT_EQ(mesh.report().surfaces[0].from_particles.positions, along);
}

TEST(MeshReport, ABoxOnItsLatticeIsExactInSpace) {
    const Inspected mesh = inspect_texts(duct);
    expect_an_exact_box(mesh, std::sqrt(0.75));
    EXPECT_EQ(mesh.report().surfaces[0].from_particles.positions, 16U * 28);  // of 8 x 8, those on the edge
}

TEST(MeshReport, ABallIsAsRoughAsALatticeCutAtAllAngles) {
    const Inspected mesh = inspect_ball("spacing = \"0.05 m\"");
    const ParticleSet& set = mesh.result.particles;
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double depth = (radius_of_ball - set.position[i].norm()) / set.spacing;
        if (set.kind(i) != PartKind::fluid || depth >= 1) continue;
        squares += (depth - 0.5) * (depth - 0.5);
        ++count;
    }
    const auto& surface = mesh.report().surfaces.at(0);
    EXPECT_NEAR(static_cast<double>(surface.from_particles.positions), static_cast<double>(count),
                0.01 * static_cast<double>(count));
    EXPECT_NEAR(surface.from_particles.rms, std::sqrt(squares / static_cast<double>(count)), 2e-3);
    // Depths evenly spread over a spacing have an RMS of 12^(-1/2); (d - 1/2)^2 then has the variance 1/80 - 1/144. Of
    // about 1100 particles six each are mirror images: the RMS has a standard deviation of 0.0095.
    EXPECT_NEAR(surface.from_particles.rms, std::sqrt(1.0 / 12), 3 * 0.0095);
    EXPECT_LE(surface.from_particles.largest, 0.5);
    // The nearest particle of a place is less than the longest half diagonal of a cell and a spacing away.
    EXPECT_LT(surface.farthest, 1 + std::sqrt(0.75));
    EXPECT_LE(surface.from_geometry.largest, surface.farthest + 0.5);
    EXPECT_GT(surface.from_geometry.rms, 0.1);
    EXPECT_LT(surface.from_geometry.rms, 0.45);
    EXPECT_LT(std::abs(mesh.report().parts[0].volume_error()), 0.01);
    EXPECT_EQ(mesh.report().leaks->particles, 0U);
    EXPECT_GT(mesh.report().layers.at(1).fewest, 1.9);
    EXPECT_LT(mesh.report().parts[0].inside.spread, 1e-6);
}

TEST(LeakTest, AHoleOfOneMissingParticleLeaks) {
    for (const Texts& texts : {channel, duct}) {
        const Meshed meshed = mesh_texts(texts);
        const ParticleSet& set = meshed.particles;
        EXPECT_EQ(find_leaks(set).particles, 0U);
        const double half = 0.0625;
        const Vec foot(9 * half, 0, set.dimension == 3 ? 9 * half : 0);
        // Three layers: without the first two of a column it is tight.
        EXPECT_EQ(find_leaks(without(set, column(set, foot, 2 * 0.125))).particles, 0U);
        const auto leaks = find_leaks(without(set, column(set, foot, 1)));
        EXPECT_GT(leaks.particles, 0U);
        EXPECT_LE(leaks.particles, 9U);
        EXPECT_LT((leaks.where - foot).norm(), 2 * set.spacing) << leaks.where.transpose();
    }
}

TEST(LeakTest, EveryArrangementIsTight) {
    for (const char* arrangement : {"square", "hexagonal"})
        EXPECT_EQ(find_leaks(mesh_texts(channel.with(
                                            "spacing = \"0.125 m\"",
                                            std::string("spacing = \"0.13 m\"\narrangement = \"") + arrangement + "\""))
                                 .particles)
                      .particles,
                  0U)
            << arrangement;
    for (const char* arrangement : {"square", "hexagonal", "fcc"})
        EXPECT_EQ(inspect_ball(std::string("spacing = \"0.08 m\"\narrangement = \"") + arrangement + "\"")
                      .report()
                      .leaks->particles,
                  0U)
            << arrangement;
}

TEST(LeakTest, WhatIsEmptyInABodyCountsAsOutside) {
    const Folder folder;
    const std::string body =
        duct.with("periodic = [\"x\"]", "periodic = [\"x\", \"y\", \"z\"]").with("0.125 m", "0.05 m").scene;
    Folder::write(body);
    const Scene scene = read_scene("scene.toml", {});
    Geometry geometry;
    geometry.dimension = 3;
    geometry.solids = {{"water", box_surface(Vec(2, 1, 1))}, {"wall", bench::icosphere(5, 0.4)}};
    for (Vec& corner : geometry.solids[1].surface.corners) corner += Vec(1, 0.5, 0.5);
    geometry.box = {Vec::Zero(), Vec(2, 1, 1)};
    Inspected mesh{mesher::mesh(geometry, scene), {}};
    mesh.detail = inspect(mesh.result, geometry, scene);
    const ParticleSet& set = mesh.result.particles;
    EXPECT_GT(find_leaks(set).cells, 100U);
    EXPECT_EQ(find_leaks(set).particles, 0U);
    const ParticleSet holed = without(set, [&](std::size_t i) {
        const Vec from_axis = set.position[i] - Vec(0, 0.525, 0.525);
        return set.kind(i) == PartKind::rigid && set.position[i].x() > 1 && std::abs(from_axis.y()) < 1e-6 &&
               std::abs(from_axis.z()) < 1e-6;
    });
    EXPECT_LT(holed.size(), set.size());
    EXPECT_GT(find_leaks(holed).particles, 0U);
    // The fluid's room is what the body leaves: its surface is the body's.
    EXPECT_LT(std::abs(mesh.report().parts[0].volume_error()), 0.01);
    EXPECT_NEAR(mesh.report().surfaces.at(0).from_particles.rms, std::sqrt(1.0 / 12), 0.05);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (!std::isnan(mesh.detail.surface_error[i])) {
            EXPECT_LT((set.position[i] - Vec(1, 0.5, 0.5)).norm(), 0.4 + set.spacing);
        }
}

TEST(MeshReport, SaysSoInWordsAndForPrograms) {
    const MeshReport report = inspect_texts(flap_channel).result.report;
    const std::string text = report.text();
    for (const char* words : {"water: volume error", "kernel sum near walls:", "nearest neighbours [spacings]:",
                              "surface of water [spacings]", "layers of wall: 3.00 on average, at least 3.00 of 3",
                              "leak test: tight", "1 piece; bonds: ", "cost: ", " candidate points/s"})
        EXPECT_THAT(text, testing::HasSubstr(words));
    const auto json = nlohmann::json::parse(report.json());
    EXPECT_EQ(json["parts"][0]["name"], report.parts[0].name);
    EXPECT_EQ(json["parts"][0]["particles"], report.parts[0].particles);
    EXPECT_EQ(json["parts"][0]["kernel_sum_inside"]["mean"], report.parts[0].inside.mean);
    std::size_t counted = 0;
    for (const auto& bar : json["parts"][0]["nearest_histogram"]["bars"])
        counted += bar["particles"].get<std::size_t>();
    EXPECT_EQ(counted, report.parts[0].particles);
    EXPECT_EQ(json["surfaces"][0]["from_drawing"]["rms"], report.surfaces[0].from_geometry.rms);
    EXPECT_EQ(json["leak_test"]["tight"], true);
    EXPECT_EQ(json["layers"].size(), report.layers.size());
    // Corners of the ladder have two bonds, all others three.
    EXPECT_EQ(json["elastic"][0]["nodes_by_number_of_bonds"][2], 4);
    EXPECT_EQ(json["elastic"][0]["pieces"], 1);
    EXPECT_GT(json["cost"]["seconds"]["fluids"]["clock"], 0);
}

}  // namespace
}  // namespace dmp::tests::mesh_report_tests
