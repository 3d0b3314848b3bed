// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "tests/end_to_end/program.hpp"

namespace dmp::tests::command_line_tests {

namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Outcome run_here(const std::vector<std::string>& arguments, const Surroundings& surroundings = {}) {
    const CaseFolder folder;
    return run_dmp(folder.path(), arguments, surroundings);
}

TEST(CommandLine, HelpGoesToStdout) {
    const auto outcome = run_here({"--help"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.output, HasSubstr("dmp run cases/vein_valve"));
    EXPECT_EQ(outcome.errors, "");
}

TEST(CommandLine, VersionIsTheProjects) {
    const auto outcome = run_here({"--version"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.output, StartsWith("dmp " DMP_PROJECT_VERSION "\n"));
}

TEST(CommandLine, UnknownCommandNamesTheNearest) {
    const auto outcome = run_here({"explian"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(outcome.errors,
              "error: there is no command 'explian'\n  Did you mean 'explain'? 'dmp --help' tells more.\n");
}

TEST(CommandLine, UnknownOptionNamesTheNearest) {
    const auto outcome = run_here({"run", "scene.toml", "--dryrun"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("Did you mean '--dry-run'?"));
}

TEST(CommandLine, NoColoursInAFile) {
    EXPECT_THAT(run_here({"run", "nowhere"}).errors, testing::Not(HasSubstr("\033")));
    EXPECT_THAT(run_here({"doctor"}).output, testing::Not(HasSubstr("\033")));
}

TEST(CommandLine, EscapeWritesItsTable) {
    const CaseFolder folder;
    const auto printed =
        run_dmp(folder.path(), {"escape", "--printed", "--friction", "0.3", "--speed", "5 m/s", "--angle", "90 deg"});
    EXPECT_EQ(printed.code, 0) << printed.errors;
    EXPECT_THAT(printed.output, testing::EndsWith("eta\n0.3,5,90,89.976,80.307,0.4998,0.4158,0.4929,0.9156\n"));
    const auto written = run_dmp(folder.path(), {"escape", "--out", "there/eta.csv"});
    EXPECT_EQ(written.code, 0) << written.errors;
    EXPECT_THAT(written.output, HasSubstr("corrected: there/eta.csv"));
    EXPECT_THAT(written.output, HasSubstr("first escape at v sin(theta) = 0.1044 m/s"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "there/eta.csv"));
    const auto wrong = run_dmp(folder.path(), {"escape", "--pull-off-force", "3"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.errors, HasSubstr("missing unit: --pull-off-force"));
}

TEST(CommandLine, OutputThatIsLostIsAnError) {
    // The output's own file is limited, so that the help does not fit.
    const auto outcome = run_here({"--help"}, {.largest_file = 10});
    EXPECT_EQ(outcome.code, 4);
}

TEST(CommandLine, DoctorLooksAtThisMachine) {
    const auto outcome = run_here({"doctor"});
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    for (const char* what :
         {"build", "vector unit", "processors", "memory", "disk", "writing", "pictures", "VTK 9", "gmsh 4"}) {
        EXPECT_THAT(outcome.output, HasSubstr(what));
    }
}

TEST(CommandLine, ExplainsAKey) {
    const auto outcome = run_here({"explain", "particles.spacing"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("particles.spacing"), HasSubstr("length")));
}

TEST(CommandLine, ExplainsOnlyWhatASceneHas) {
    const CaseFolder folder;
    folder.copy_case("verification/cantilever");
    const auto solid = run_dmp(folder.path(), {"explain", "."});
    EXPECT_EQ(solid.code, 0) << solid.errors;
    EXPECT_THAT(solid.output, HasSubstr("springs strip"));
    for (const char* of_fluids : {"equation of state", "kernel", "shifting", "walls  "})
        EXPECT_THAT(solid.output, Not(HasSubstr(of_fluids)));

    const CaseFolder at_rest;
    at_rest.copy_case("verification/diffusion");
    const auto species = run_dmp(at_rest.path(), {"explain", "."});
    EXPECT_THAT(species.output, HasSubstr("only species are stepped"));
    EXPECT_THAT(species.output, Not(HasSubstr("equation of state")));
    EXPECT_THAT(species.output + species.errors, Not(HasSubstr("nothing will move"))) << "it diffuses";

    const CaseFolder taken_up;
    taken_up.copy_case("verification/uptake");
    EXPECT_THAT(run_dmp(taken_up.path(), {"explain", "."}).output, HasSubstr("taken up at 0.8 1/s in tissue"));
}

TEST(CommandLine, CommandsThatDoNotUseSeveralRanksRefuseThem) {
    const auto outcome = run_here({"mesh", "scene.toml"}, {.environment = {"OMPI_COMM_WORLD_SIZE=4"}});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, testing::AllOf(HasSubstr("4 MPI ranks"), HasSubstr("without mpirun")));
}

}  // namespace

}  // namespace dmp::tests::command_line_tests
