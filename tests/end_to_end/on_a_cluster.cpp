// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Particles that go from machine to machine in a file, and the dmp that is built without gmsh, CGAL and VTK.
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::on_a_cluster_tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class OnACluster : public SmallValve {
  protected:
    void make_particles(const Words& more = {}) const {
        Words words{"--particles", "to_take/valve.h5"};
        words.insert(words.end(), more.begin(), more.end());
        const auto outcome = mesh("mesh", words);
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_THAT(outcome.output, HasSubstr("to_take/valve.h5"));
    }
    /// Briefly, with the particles of the file.
    [[nodiscard]] Outcome run_them(const std::string& out, Words more = {}, const Surroundings& with = {}) const {
        more.insert(more.end(), {"--until", "0.03 s", "--particles", "to_take/valve.h5"});
        return run(out, more, with);
    }
    void expect_refused(const Words& more, const testing::Matcher<const std::string&>& errors) const {
        const auto outcome = run_them("refused", more);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.errors, AllOf(StartsWith("error: to_take/valve.h5: "), errors));
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "refused"));
    }
};

TEST_F(OnACluster, ParticlesOfAFileRunAsThoseOfTheDrawing) {
    ASSERT_EQ(run("whole", {"--until", "0.03 s"}).code, 0);
    make_particles();
    ASSERT_EQ(run_them("out").code, 0);
    EXPECT_EQ(hash("out"), hash("whole"));
    EXPECT_EQ(folder_.read("out/measures.csv"), folder_.read("whole/measures.csv"));
    EXPECT_EQ(folder_.read("out/frames/solid_000003.vtp"), folder_.read("whole/frames/solid_000003.vtp"));

    for (const int ranks : {0, 2}) {
        const auto outcome = run_them("there", {"--overwrite"}, {.ranks = ranks, .for_clusters = true});
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_EQ(hash("there"), hash("whole")) << ranks << " ranks";
        EXPECT_EQ(folder_.read("there/measures.csv"), folder_.read("whole/measures.csv"));
        EXPECT_THAT(outcome.output, AllOf(HasSubstr("springs leaflets  k_b 1.2e+04 N/m, k_a 0.0015 J, from the file"),
                                          HasSubstr("dmp convert there"), Not(HasSubstr("paraview"))));
    }
    // And back on the workstation.
    const auto converted = run_dmp(folder_.path(), {"convert", "there"});
    ASSERT_EQ(converted.code, 0) << converted.errors;
    for (const std::string file : {"fluid.pvd", "walls.vtp", "frames/fluid_000003.vtp", "frames/solid_000003.vtp"})
        EXPECT_EQ(folder_.read("there/" + file), folder_.read("whole/" + file)) << file;
}

TEST_F(OnACluster, WhatParticlesDoNotDependOnMayChange) {
    make_particles();
    const auto outcome =
        run_them("out", {"--set", "part.blood.viscosity=\"4 mPa*s\"", "--set", "flow.largest_speed=\"0.2 m/s\""});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
}

TEST_F(OnACluster, ParticlesOfAnotherSceneAreRefusedWithTheDifference) {
    make_particles();
    expect_refused({"--set", "particles.spacing=\"0.4 mm\""},
                   AllOf(HasSubstr("\n  particles.spacing: 0.0005 m in the file, 0.0004 m in the scene\n"),
                         HasSubstr("dmp mesh SCENE --particles FILE.h5")));
    expect_refused({"--set", "flow.periodic=[\"y\"]", "--set", "flow.pressure_gradient=[0, 0]"},
                   AllOf(HasSubstr("\n  flow.periodic along x: yes in the file, no in the scene\n"),
                         HasSubstr("\n  flow.periodic along y: no in the file, yes in the scene\n")));
    expect_refused({"--set", "part.leaflets.enabled=false"},
                   HasSubstr("\n  part 'leaflets': elastic in the file, not there in the scene\n"));
    expect_refused({"--set", "part.leaflets.bending_stiffness=\"1e-6 N*m^2\""},
                   HasSubstr("\n  part.leaflets.bending_stiffness: \"3e-06 N*m^2\" in the file, "
                             "\"1e-06 N*m^2\" in the scene\n"));
    expect_refused({"--set", "geometry.parameters.leaflet_length=\"16 mm\""}, HasSubstr("\n  geometry.parameters: "));
}

TEST_F(OnACluster, ADamagedParticleFileOrNoneIsRefused) {
    make_particles();
    const auto file = folder_.path() / "to_take/valve.h5";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    expect_refused({}, HasSubstr("truncated"));
    std::filesystem::remove(file);
    expect_refused({}, HasSubstr("valve.h5"));
    // Under mpirun it is said once.
    const auto outcome = run_them("refused", {}, {.ranks = 2});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.errors.find("error: "), outcome.errors.rfind("error: ")) << outcome.errors;
}

TEST_F(OnACluster, WithoutAFileItSaysWhatToDo) {
    const auto outcome = run("out", {}, {.for_clusters = true});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors,
                AllOf(HasSubstr("built for clusters"), HasSubstr("dmp mesh SCENE --particles FILE.h5")));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(OnACluster, ItDoesNotDoWhatItWasNotBuiltFor) {
    const Surroundings there{.for_clusters = true};
    for (const Words& words : {Words{"mesh", "."}, Words{"convert", "."}, Words{"run", ".", "--frames", "vtk"}}) {
        const auto outcome = run_dmp(folder_.path(), words, there);
        EXPECT_EQ(outcome.code, 2) << words.front();
        EXPECT_THAT(outcome.errors, HasSubstr("built for clusters")) << words.front();
    }
    const auto doctor = run_dmp(folder_.path(), {"doctor"}, there);
    EXPECT_EQ(doctor.code, 0);
    EXPECT_THAT(doctor.output, AllOf(HasSubstr("for clusters"), Not(HasSubstr("VTK")), Not(HasSubstr("gmsh")),
                                     Not(HasSubstr("ParaView")), Not(HasSubstr("Xvfb"))));
    EXPECT_EQ(run_dmp(folder_.path(), {"explain", "particles.spacing"}, there).code, 0);
}

}  // namespace

}  // namespace dmp::tests::on_a_cluster_tests
