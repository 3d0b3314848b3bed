// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "cli/arguments.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_arguments_tests {

namespace {

using namespace cli;
using testing::ElementsAre;
using testing::HasSubstr;

Command read(std::initializer_list<const char*> words) {
    std::vector<const char*> argv{"dmp"};
    argv.insert(argv.end(), words);
    return read_arguments(argv);
}

/// What is thrown for these words, or an error that says nothing was.
InputError error_of(std::initializer_list<const char*> words) {
    try {
        read(words);
    } catch (const InputError& error) {
        return error;
    }
    return {"nothing was thrown", ""};
}

std::string text_of(std::initializer_list<const char*> words) { return std::get<PrintCommand>(read(words)).text; }

TEST(Arguments, SweepTakesAllItsOptions) {
    const auto sweep = std::get<SweepCommand>(
        read({"sweep", "my.toml", "--out", "there", "--jobs", "3", "--only", "a.b=1 m", "--only", "c=d", "--resume"}));
    EXPECT_EQ(sweep.study, "my.toml");
    EXPECT_EQ(sweep.out, "there");
    EXPECT_EQ(sweep.jobs, 3);
    EXPECT_THAT(sweep.only, ElementsAre("a.b=1 m", "c=d"));
    EXPECT_TRUE(sweep.resume);
    EXPECT_FALSE(sweep.overwrite || sweep.dry_run);
    EXPECT_EQ(sweep.typed.with("--overwrite"),
              "dmp sweep my.toml --out there --jobs 3 --only 'a.b=1 m' --only c=d --overwrite");
    EXPECT_THAT(error_of({"sweep"}).problem(), HasSubstr("a study is missing"));
    EXPECT_THAT(error_of({"sweep", "my.toml", "--jobs", "0"}).problem(),
                HasSubstr("'0' is not a whole number from 1 on"));
    EXPECT_THAT(error_of({"sweep", "my.toml", "--job", "2"}).what_to_do(), HasSubstr("Did you mean '--jobs'?"));
}

TEST(Arguments, RunTakesAllItsOptions) {
    const auto run =
        std::get<RunCommand>(read({"run", "cases/a", "--out", "there", "--until", "0.2 s", "--set", "a.b=1 m", "--set",
                                   "c=d=e", "--threads", "3", "--vector-unit", "avx2", "--dry-run"}));
    EXPECT_EQ(run.scene.path, "cases/a");
    EXPECT_THAT(run.scene.overrides, ElementsAre("a.b=1 m", "c=d=e"));
    EXPECT_EQ(run.out, "there");
    EXPECT_EQ(run.until, "0.2 s");
    EXPECT_EQ(run.threads, 3);
    EXPECT_EQ(run.vector_unit, VectorUnit::avx2);
    EXPECT_TRUE(run.dry_run);
}

TEST(Arguments, EscapeSweepsWhatItIsNotGiven) {
    const auto all = std::get<EscapeCommand>(read({"escape"}));
    EXPECT_EQ(all.speeds.size(), 20U);
    EXPECT_EQ(all.speeds.back(), "20 m/s");
    EXPECT_EQ(all.angles.size(), 8U);
    EXPECT_THAT(all.friction, ElementsAre(0.1, 0.3, 0.5, 1));
    EXPECT_FALSE(all.printed);
    EXPECT_EQ(all.particle_mass, "84.4 pg");
    const auto one = std::get<EscapeCommand>(
        read({"escape", "--speed", "5 m/s", "--angle=90 deg", "--angle", "45 deg", "--friction", "0.2", "--printed",
              "--thesis-stiffness", "--pull-off-force", "3 nN", "--out", "eta.csv"}));
    EXPECT_THAT(one.speeds, ElementsAre("5 m/s"));
    EXPECT_THAT(one.angles, ElementsAre("90 deg", "45 deg"));
    EXPECT_THAT(one.friction, ElementsAre(0.2));
    EXPECT_TRUE(one.printed && one.thesis_stiffness);
    EXPECT_EQ(one.pull_off_force, "3 nN");
    EXPECT_EQ(one.out, "eta.csv");
}

TEST(Arguments, RunNeedsOnlyAScene) {
    const auto run = std::get<RunCommand>(read({"run", "x.toml"}));
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.until, "");
    EXPECT_EQ(run.threads, 0);
    EXPECT_EQ(run.vector_unit, VectorUnit::widest);
    EXPECT_FALSE(run.dry_run);
}

TEST(Arguments, RunsLeaveOutWhatIsNamed) {
    using enum study::RunOutput;
    EXPECT_THAT(std::get<RunCommand>(read({"run", "x.toml"})).left_out, testing::IsEmpty());
    const auto run =
        std::get<RunCommand>(read({"run", "x.toml", "--leave-out", "frames,page", "--leave-out=checkpoint"}));
    EXPECT_THAT(run.left_out, ElementsAre(frames, page, checkpoint));
    EXPECT_THAT(error_of({"run", "x.toml", "--leave-out", "film"}).problem(),
                HasSubstr("'film' is nothing to leave out; there are 'frames', 'pictures', 'page' and 'checkpoint'"));
}

TEST(Arguments, ParticlesAndFramesGoThroughFiles) {
    const auto run = std::get<RunCommand>(read({"run", "x.toml", "--particles", "x.h5", "--frames", "hdf5"}));
    EXPECT_EQ(run.scene.particles, "x.h5");
    EXPECT_EQ(run.frames, FrameFormat::hdf5);
    EXPECT_EQ(std::get<RunCommand>(read({"run", "x.toml", "--frames=vtk"})).frames, FrameFormat::vtk);
    EXPECT_EQ(std::get<RunCommand>(read({"run", "x.toml"})).frames, std::nullopt);
    EXPECT_EQ(std::get<RunCommand>(read({"run", "x.toml"})).scene.particles, "");
    EXPECT_EQ(std::get<MeshCommand>(read({"mesh", "x.toml", "--particles", "x.h5"})).particles, "x.h5");
    EXPECT_EQ(std::get<ExplainCommand>(read({"explain", "x.toml", "--particles", "x.h5"})).subject.particles, "x.h5");
    EXPECT_EQ(error_of({"run", "x", "--frames", "vtp"}).problem(),
              "--frames: 'vtp' is no format of frames; there are 'vtk' and 'hdf5'");
}

TEST(Arguments, SetBeforeTheSceneLeavesTheSceneAlone) {
    const auto run = std::get<RunCommand>(read({"run", "--set", "a=1", "x.toml"}));
    EXPECT_EQ(run.scene.path, "x.toml");
    EXPECT_THAT(run.scene.overrides, ElementsAre("a=1"));
}

TEST(Arguments, SetKeepsBracketsBracesQuotesAndCommas) {
    const auto run = std::get<RunCommand>(read({"run", "x", "--set", R"(flow.acceleration=["1 m/s^2, 2", 0])",
                                                R"(--set=geometry.parameters={ l = "1 mm" })"}));
    EXPECT_THAT(run.scene.overrides,
                ElementsAre(R"(flow.acceleration=["1 m/s^2, 2", 0])", R"(geometry.parameters={ l = "1 mm" })"));
}

TEST(Arguments, ANegativeTimeReachesTheCommand) {
    EXPECT_EQ(std::get<RunCommand>(read({"run", "x", "--until", "-1 s"})).until, "-1 s");
}

TEST(Arguments, MeshConvertExplainAndDoctor) {
    EXPECT_EQ(std::get<MeshCommand>(read({"mesh", "x", "--out", "y"})).out, "y");
    EXPECT_EQ(std::get<ConvertCommand>(read({"convert", "out/x"})).folder, "out/x");
    EXPECT_EQ(std::get<ExplainCommand>(read({"explain", "particles.spacing"})).subject.path, "particles.spacing");
    EXPECT_TRUE(std::holds_alternative<DoctorCommand>(read({"doctor"})));
}

TEST(Arguments, InspectAndNewTakeADrawingAndItsUnit) {
    const auto inspect = std::get<InspectCommand>(read({"inspect", "a.stl", "--unit", "mm", "--json"}));
    EXPECT_EQ(inspect.file, "a.stl");
    EXPECT_EQ(inspect.unit, "mm");
    EXPECT_TRUE(inspect.json);
    EXPECT_FALSE(std::get<InspectCommand>(read({"inspect", "a.step"})).json);
    const auto made = std::get<NewCommand>(read({"new", "pipe", "--from", "a.stl"}));
    EXPECT_EQ(made.folder, "pipe");
    EXPECT_EQ(made.cad_geometry, "a.stl");
    EXPECT_EQ(made.unit, "");
    EXPECT_EQ(error_of({"inspect"}).problem(), "a geometry is missing");
    EXPECT_EQ(error_of({"new", "--from", "a.stl"}).problem(), "a name for the new folder is missing");
    EXPECT_THAT(error_of({"new", "pipe"}).problem(), HasSubstr("--from"));
}

TEST(Arguments, TheReaderOfDrawingsIsNoCommandToSee) {
    EXPECT_TRUE(std::holds_alternative<ReadGeometryCommand>(read({"read-geometry"})));
    EXPECT_TRUE(std::holds_alternative<StartRunsCommand>(read({"start-runs"})));
    EXPECT_THAT(text_of({"--help"}), testing::Not(HasSubstr("read-geometry")));
}

TEST(Arguments, UnknownCommandNamesTheNearest) {
    const auto error = error_of({"explian", "x"});
    EXPECT_EQ(error.problem(), "there is no command 'explian'");
    EXPECT_THAT(error.what_to_do(), HasSubstr("Did you mean 'explain'?"));
    EXPECT_THAT(error_of({"rnu"}).what_to_do(), HasSubstr("Did you mean 'run'?"));
}

TEST(Arguments, UnknownCommandFarFromAllListsThem) {
    const auto error = error_of({"xyzzy"});
    EXPECT_EQ(error.problem(), "there is no command 'xyzzy'");
    EXPECT_THAT(error.what_to_do(),
                HasSubstr("'run', 'sweep', 'trade', 'limits', 'mesh', 'inspect', 'new', 'convert', 'pictures', "
                          "'report', 'explain', 'escape' and 'doctor'"));
}

TEST(Arguments, UnknownOptionNamesTheNearest) {
    const auto error = error_of({"run", "x", "--thread=2"});
    EXPECT_EQ(error.problem(), "'dmp run' has no option '--thread'");
    EXPECT_THAT(error.what_to_do(), HasSubstr("Did you mean '--threads'?"));
    EXPECT_EQ(error_of({"--versoin"}).problem(), "'dmp' has no option '--versoin'");
}

TEST(Arguments, AWordTooManyIsAnError) {
    const auto error = error_of({"run", "x", "--until", "0.2", "s"});
    EXPECT_EQ(error.problem(), "'dmp run' does not know what to do with 's'");
    EXPECT_THAT(error.what_to_do(), HasSubstr("quotes"));
}

TEST(Arguments, MissingSceneValueAndBadNumberAreErrors) {
    EXPECT_EQ(error_of({"run"}).problem(), "a scene is missing");
    EXPECT_EQ(error_of({"explain"}).problem(), "a scene or a key is missing");
    EXPECT_EQ(error_of({"convert"}).problem(), "a folder is missing");
    EXPECT_THAT(error_of({"run", "x", "--out"}).problem(), HasSubstr("--out"));
    EXPECT_THAT(error_of({"run", "x", "--threads", "0"}).problem(), HasSubstr("--threads"));
    EXPECT_THAT(error_of({"run", "x", "--threads", "two"}).problem(), HasSubstr("two"));
}

TEST(Arguments, UnknownVectorUnitNamesTheKnownOnes) {
    EXPECT_EQ(std::get<RunCommand>(read({"run", "x", "--vector-unit=avx512"})).vector_unit, VectorUnit::avx512);
    for (const char* wrong : {"sse", "AVX2", "widest", "generic", ""}) {
        const auto error = error_of({"run", "x", "--vector-unit", wrong});
        EXPECT_EQ(error.problem(),
                  std::string("--vector-unit: '") + wrong + "' is no vector unit; there are 'avx2' and 'avx512'");
    }
}

TEST(Arguments, HelpShowsCommandsExamplesAndExitCodes) {
    const std::string help = text_of({"--help"});
    for (const char* word : {"run", "mesh", "inspect", "new", "convert", "explain", "escape", "doctor",
                             "Examples:", "dmp run cases/vein_valve", "Exit codes:"}) {
        EXPECT_THAT(help, HasSubstr(word));
    }
    EXPECT_EQ(text_of({}), help);
}

TEST(Arguments, HelpOfACommandShowsItsOptions) {
    const std::string help = text_of({"run", "--help"});
    for (const char* word : {"dmp run", "--out DIR", "--until TIME", "--set KEY=VALUE", "--threads N",
                             "--vector-unit UNIT", "--dry-run"}) {
        EXPECT_THAT(help, HasSubstr(word));
    }
}

TEST(Arguments, HelpUsesTheNameDmpWasCalledBy) {
    const std::array<const char*, 2> argv{"./dmp", "--help"};
    EXPECT_THAT(std::get<PrintCommand>(read_arguments(argv)).text, HasSubstr("./dmp run cases/vein_valve"));
}

TEST(Arguments, VersionNamesVersionAndLicence) {
    EXPECT_THAT(text_of({"--version"}), testing::AllOf(testing::StartsWith("dmp "), HasSubstr("GPL-3.0-or-later")));
}

}  // namespace

}  // namespace dmp::tests::cli_arguments_tests
