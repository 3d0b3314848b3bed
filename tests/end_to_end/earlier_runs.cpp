// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a run does with the results that an earlier one has left: no run is lost by a command that does not say so.
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>

#include "base/seal.hpp"
#include "solver/state/checkpoint_file.hpp"
#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::earlier_runs_tests {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class EarlierRuns : public SmallValve {
  protected:
    /// Every file of a folder with its text.
    [[nodiscard]] std::map<std::string, std::string> all_of(const std::string& out) const {
        std::map<std::string, std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / out)) {
            const std::string name = fs::relative(entry.path(), folder_.path()).string();
            found[name] = entry.is_regular_file() ? folder_.read(name) : "a folder";
        }
        return found;
    }

    /// The line of an error that ends with these words, as a user pastes it into a shell; its exit code.
    [[nodiscard]] int paste(const std::string& errors, const std::string& end) const {
        std::istringstream lines(errors);
        for (std::string line; std::getline(lines, line);)
            if (line.ends_with(end)) {
                const std::string in_folder = "cd '" + folder_.path().string() +
                                              "' && XDG_CACHE_HOME=" + (folder_.path() / ".cache").string() + line +
                                              " >/dev/null";
                const int status = std::system(in_folder.c_str());
                return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            }
        ADD_FAILURE() << "no line ends with " << end << " in\n" << errors;
        return -1;
    }

    void expect_refused(const std::string& out, const Words& more,
                        const testing::Matcher<const std::string&>& errors) const {
        const auto before = all_of(out);
        const auto refused = run(out, more);
        EXPECT_EQ(refused.code, 2);
        EXPECT_THAT(refused.errors, errors);
        EXPECT_EQ(all_of(out), before) << "a refused run must change nothing";
    }

    const Words other_values_{"--set", "part.blood.viscosity=\"4 mPa*s\""};
};

TEST_F(EarlierRuns, AForgottenResumeIsRefusedAndTheLineForItWorks) {
    ASSERT_EQ(run("whole").code, 0);
    ASSERT_EQ(stopped_run("out").code, 143);
    expect_refused("out", {}, HasSubstr("error: out: it holds this run, unfinished\n"));
    EXPECT_EQ(paste(run("out").errors, " --resume"), 0);
    EXPECT_EQ(hash("out"), hash("whole"));
    EXPECT_EQ(files("out/frames"), files("whole/frames"));
}

TEST_F(EarlierRuns, AnUnfinishedRunIsRemovedWhereTheLineSaysSo) {
    ASSERT_EQ(stopped_run("out").code, 143);
    folder_.write("out/notes.txt", "mine");
    EXPECT_EQ(paste(run("out", {"--until", "0.02 s"}).errors, " --overwrite"), 0);
    EXPECT_EQ(summary("out")["interrupted"], false);
    EXPECT_THAT(files("out/frames"), Not(Contains("fluid_000003.vtp")));
    EXPECT_EQ(folder_.read("out/notes.txt"), "mine");
}

TEST_F(EarlierRuns, AFinishedRunIsKeptFromOtherValues) {
    const Words briefly{"--until", "0.02 s"};
    ASSERT_EQ(run("out", briefly).code, 0);
    expect_refused("out", briefly, HasSubstr("error: out: it holds this run already, finished at t = 0.02 s\n"));
    expect_refused("out", {"--until", "0.03 s"}, HasSubstr("finished at t = 0.02 s; this one would end at 0.03 s"));

    const auto first = all_of("out");
    Words changed = other_values_;
    changed.insert(changed.end(), briefly.begin(), briefly.end());
    expect_refused("out", changed,
                   AllOf(HasSubstr("it holds a finished run of another scene or other values:\n  part.blood.viscosity: "
                                   "was \"0.0035 "),
                         HasSubstr("is \"0.004 "), Not(HasSubstr("density"))));
    EXPECT_EQ(paste(run("out", changed).errors, " --out out_2"), 0);
    EXPECT_EQ(all_of("out"), first);
    EXPECT_NE(hash("out_2"), hash("out"));
    EXPECT_THAT(run("out", changed).errors, HasSubstr(" --out out_3\n"));
    EXPECT_EQ(paste(run("out", changed).errors, " --overwrite"), 0);
    EXPECT_EQ(hash("out"), hash("out_2"));
}

TEST_F(EarlierRuns, OfTheDefaultFolderAreKept) {
    const auto in_default_folder = [&](Words words) {
        words.insert(words.begin(), {"run", "scene.toml", "--threads", "1", "--until", "0.01 s", "--set",
                                     "particles.spacing=\"0.5 mm\"", "--set", "output.pictures=false"});
        return run_dmp(folder_.path(), words);
    };
    const std::string name = folder_.path().filename().string();
    ASSERT_EQ(in_default_folder({}).code, 0);
    const auto refused = in_default_folder(other_values_);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr(" --out out/" + name + "_2\n"));
}

TEST_F(EarlierRuns, AreNotRemovedByARunThatCannotStart) {
    ASSERT_EQ(run("out", {"--until", "0.01 s"}).code, 0);
    const auto before = all_of("out");
    const std::vector<Words> wrong{{"--set", "particles.spacin=1"},
                                   {"--particles", "none.h5"},
                                   {"--until", "0.2"},
                                   {"--set", "geometry.file=\"none.geo\""},
                                   {"--resume"}};
    for (Words words : wrong) {
        words.emplace_back("--overwrite");
        EXPECT_EQ(run("out", words).code, 2) << words.front() << words.back();
        EXPECT_EQ(all_of("out"), before) << words.front();
    }
    EXPECT_EQ(run("out", {"--overwrite", "--frames", "vtk", "--particles", "none.h5"}, {.for_clusters = true}).code, 2);
    EXPECT_EQ(run("out", {"--overwrite", "--dry-run"}).code, 0);
    EXPECT_EQ(all_of("out"), before);
}

TEST_F(EarlierRuns, AreNotRemovedByAMeshAndAMeshIsReplacedByAnother) {
    ASSERT_EQ(run("out", {"--until", "0.01 s"}).code, 0);
    const auto before = all_of("out");
    const auto refused = mesh("out");
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("it holds the results of a run"), HasSubstr(" --out out_2\n")));
    EXPECT_EQ(all_of("out"), before);
    ASSERT_EQ(mesh("mesh").code, 0);
    EXPECT_THAT(mesh("mesh").output, HasSubstr("of an earlier run from mesh"));
    EXPECT_EQ(run("mesh", {"--until", "0.01 s"}).code, 2);
    EXPECT_EQ(run("mesh", {"--until", "0.01 s", "--overwrite"}).code, 0);
    EXPECT_EQ(mesh("mesh").code, 2);
}

TEST_F(EarlierRuns, OfADivergedRunAreKept) {
    const Words divergent{"--set", "flow.pressure_gradient=[\"-1e6 Pa/m\", 0]"};
    ASSERT_EQ(run("out", divergent).code, 3);
    expect_refused("out", divergent,
                   AllOf(HasSubstr("it holds a run that did not get to its end"), HasSubstr(" --overwrite\n")));
}

TEST_F(EarlierRuns, LeaveNoLockBehind) {
    ASSERT_EQ(run("out", {"--until", "0.01 s"}).code, 0);
    EXPECT_EQ(run("out").code, 2);
    EXPECT_THAT(files("out"), Not(Contains("dmp.lock")));
    EXPECT_EQ(run("none", {"--resume"}).code, 2);
    EXPECT_FALSE(fs::exists(folder_.path() / "none"));
}

TEST_F(EarlierRuns, AreKeptByAStartFromAStateThatLacksSomething) {
    ASSERT_EQ(run("first", {"--until", "0.01 s"}).code, 0);
    ASSERT_EQ(run("second", {"--until", "0.01 s"}).code, 0);
    const std::string state = "first/checkpoints/" + files("first/checkpoints").back();
    folder_.replace(state, "suction", "section");  // as if by a dmp without it
    seal(folder_.path() / state, solver::checkpoint_kind, state);
    expect_refused("second", {"--from", "first", "--until", "0.02 s", "--overwrite"},
                   HasSubstr("the checkpoint holds no 'reference/suction', which the scene needs now"));
    // A new folder is not made, so that the next run finds nothing in its way.
    EXPECT_EQ(run("third", {"--from", "first", "--until", "0.02 s"}).code, 2);
    EXPECT_FALSE(fs::exists(folder_.path() / "third"));
}

}  // namespace

}  // namespace dmp::tests::earlier_runs_tests
