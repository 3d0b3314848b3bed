// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The cases in 3-D: how good their particles are.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "meshed_text.hpp"
#include "mesher/inspect.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::space_case_meshes_tests {
namespace {

/// Struts, and as much of the artery as they take.
const std::vector<std::string> short_artery{"geometry.parameters.length=6 mm", "geometry.parameters.first=0.6 mm"};

std::vector<std::string> with(std::vector<std::string> overrides, const std::vector<std::string>& more) {
    overrides.insert(overrides.end(), more.begin(), more.end());
    return overrides;
}

MeshReport inspected(const Meshed& meshed) {
    MeshResult result{meshed.particles, meshed.report, {}};
    (void)inspect(result, meshed.geometry, meshed.scene);
    return result.report;
}

TEST(StentMesh, IsFittedAndTight) {
    const Meshed meshed = mesh_case("stent", short_artery);
    const MeshReport report = inspected(meshed);
    const MeshReport::PartLine& blood = report.parts.at(0);
    EXPECT_LT(std::abs(blood.volume_error()), 0.01);
    EXPECT_LT(blood.inside.spread, 0.01);
    EXPECT_LT(blood.near_walls.spread, 0.03);
    EXPECT_LT(report.surfaces.at(0).from_geometry.rms, 0.05);
    EXPECT_LT(report.surfaces.at(0).from_particles.rms, 0.05);
    EXPECT_EQ(report.leaks->particles, 0U);
}

TEST(StentMesh, BloodKeepsOffTheStrutsAndTheWall) {
    const Meshed meshed = mesh_case("stent", with(short_artery, {"particles.fill=lattice"}));
    const ParticleSet& set = meshed.particles;
    std::size_t above_struts = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec& position = set.position[i];
        EXPECT_GT(position.y(), 0);
        EXPECT_GT(position.z(), 0);
        if (set.kind(i) != PartKind::fluid) continue;
        const double r = std::hypot(position.y(), position.z());
        EXPECT_LT(r, 1.5e-3);
        const double along = std::fmod(position.x() - 0.6e-3 + 1.2e-3, 1.2e-3);
        const bool at_ring = position.x() > 0.6e-3 && position.x() < 4.5e-3 && along < 0.3e-3;
        if (!at_ring) continue;
        EXPECT_LT(r, 1.2e-3 + 1e-6);
        ++above_struts;
    }
    EXPECT_GT(above_struts, 100U);
}

TEST(StentMesh, StepFileGivesTheSameParticles) {
    const Folder folder;
    Folder::write(R"(schema = 1
dimension = 3
[geometry]
file = ")" DMP_SOURCE_DIR R"(/cases/stent/stent.step"
[particles]
spacing = "0.3 mm"
[[select]]
name = "inlet"
of = "blood"
x = "0 mm"
[[select]]
name = "outlet"
of = "blood"
x = "24 mm"
[[select]]
name = "wall"
of = "blood"
except = ["inlet", "outlet"]
[[part]]
name = "blood"
kind = "fluid"
density = "1060 kg/m^3"
viscosity = "3.5 mPa*s"
[[part]]
name = "wall"
kind = "rigid"
[[part]]
name = "stent"
kind = "rigid"
[flow]
periodic = ["x"]
largest_speed = "0.5 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)");
    const Meshed step = mesh_file("scene.toml");
    const Meshed drawn = mesh_case("stent", {"particles.fill=lattice", "particles.spacing=0.3 mm"});
    for (const PartKind kind : {PartKind::fluid, PartKind::rigid}) {
        const auto quarters = 4 * static_cast<double>(drawn.particles.count(kind));
        EXPECT_NEAR(static_cast<double>(step.particles.count(kind)) / quarters, 1, 0.005);
    }
}

TEST(StentMesh, WithoutTheStentAnArtery) {
    const Meshed meshed = mesh_case("stent", with(short_artery, {"part.stent.enabled=false"}));
    EXPECT_NEAR(meshed.report.parts.at(0).volume_error(), 0, 0.01);
    EXPECT_EQ(inspected(meshed).leaks->particles, 0U);
}

TEST(TricuspidValveMesh, HasThreeLeafletsThatItsBloodKeepsOff) {
    const Meshed meshed = mesh_case("tricuspid_valve");
    const MeshReport report = inspected(meshed);
    EXPECT_EQ(report.leaks->particles, 0U);
    const MeshReport::SpringLine& leaflets = report.springs.at(0);
    EXPECT_EQ(leaflets.bodies, 3);
    EXPECT_GT(leaflets.anchored, 3U * 10);
    const ParticleSet& set = meshed.particles;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t node = 0; node < set.size(); ++node)
        for (std::size_t i = 0; i < set.size() && set.kind(node) == PartKind::elastic; ++i)
            if (set.kind(i) == PartKind::fluid)
                nearest = std::min(nearest, (set.position[i] - set.position[node]).norm());
    EXPECT_GT(nearest, 0.75 * set.spacing);
}

}  // namespace
}  // namespace dmp::tests::space_case_meshes_tests
