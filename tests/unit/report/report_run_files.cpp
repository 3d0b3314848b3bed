// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "report/run_files.hpp"
#include "tests/unit/report/run_folder.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::report_run_files_tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class RunFilesOf : public testing::Test {
  protected:
    [[nodiscard]] std::string error() const {
        return text_thrown<InputError>([&] { static_cast<void>(folder_.read()); });
    }
    RunFolder folder_;
};

TEST_F(RunFilesOf, HaveWhatTheRunLeft) {
    const RunFiles run = folder_.read();
    EXPECT_THAT(run.notes, IsEmpty());
    ASSERT_THAT(run.pictures, SizeIs(2)) << "none of another folder";
    EXPECT_EQ(run.pictures[0].name, "last_frame.png");
    EXPECT_EQ(run.pictures[0].width, 7U);
    EXPECT_EQ(run.pictures[0].height, 5U);
    EXPECT_EQ(run.frames, 2);
    ASSERT_TRUE(run.measures);
    EXPECT_THAT(run.measures->names, ElementsAre("flux"));
    EXPECT_THAT(run.resolved_scene, HasSubstr("alert('scene')"));
}

TEST_F(RunFilesOf, TheLogHasStartsAndEachWarningOnce) {
    const LoggedRun log = folder_.read().log;
    ASSERT_THAT(log.starts, SizeIs(2));
    EXPECT_EQ(log.starts[0].when, "2026-11-26 23:34:03 UTC");
    EXPECT_EQ(log.starts[0].version, "0.1.0");
    EXPECT_EQ(log.starts[0].command, "dmp run valve --set 'a=<b>'");
    EXPECT_EQ(log.starts[1].command, "dmp run valve --resume");
    EXPECT_THAT(log.warnings, ElementsAre("leaflets: EA <lowered>", "at 0.1 s: too <fast>"));
    EXPECT_THAT(logged_run("").starts, IsEmpty());
    EXPECT_THAT(logged_run("2026-11-26 23:34:03 UTC  dmp 0.1.0").starts, SizeIs(1)) << "cut off";
}

TEST_F(RunFilesOf, WhatIsMissingIsNoted) {
    for (const auto& [name, note] :
         std::vector<std::pair<std::string, std::string>>{{"measures.csv", "the measures over time are missing"},
                                                          {"run.log", "with which command"},
                                                          {"scene.resolved.toml", "the scene as it was run"},
                                                          {"last_frame.png", "last_frame.png is not in the folder"}}) {
        const RunFolder folder;
        folder.remove(name);
        EXPECT_THAT(folder.read().notes, ElementsAre(HasSubstr(note)));
    }
}

TEST_F(RunFilesOf, PicturesThatAreNoneOrTooLargeAreNoted) {
    folder_.write("last_frame.png", "no picture");
    folder_.write("measures.png", png_file(9, 9, most_picture_bytes));
    const RunFiles run = folder_.read();
    EXPECT_THAT(run.pictures, IsEmpty());
    EXPECT_THAT(run.notes, ElementsAre("last_frame.png is not a whole PNG file and is left out",
                                       HasSubstr("measures.png (2.5 MB) is left out")));
}

TEST_F(RunFilesOf, HaveReferencesWhereTheyAreThere) {
    EXPECT_THAT(folder_.read().references.names, IsEmpty());
    folder_.write("references.csv", "time [s],flux [m^3/s]\n0,1\n0.5,3\n");
    const RunFiles run = folder_.read();
    EXPECT_THAT(run.references.names, ElementsAre("flux"));
    EXPECT_EQ(run.references.rows[1][0], 3);
    EXPECT_THAT(run.notes, IsEmpty());
    folder_.write("references.csv", "time [s],flux [m^3/s]\n0,1\n0.5");
    EXPECT_THAT(folder_.read().notes, ElementsAre("references.csv is damaged: found 1 values, expected 2"));
}

TEST_F(RunFilesOf, FramesThatCannotBeReadAreNoted) {
    EXPECT_THAT(folder_.read().particles.times, ElementsAre(0, 0.5));
    const auto notes = [&](const OpenParaviewFrames& open) { return read_run_files(folder_.path(), open).notes; };
    EXPECT_THAT(notes([](const auto&) { return nullptr; }), ElementsAre(HasSubstr("this dmp was built for clusters")));
    EXPECT_THAT(notes([](const auto& folder) -> std::unique_ptr<FrameSource> {
                    throw InputError(SourceLocation{(folder / "fluid.pvd").string(), 0, 0}, "is damaged", "");
                }),
                ElementsAre(HasSubstr("the particles are left out: is damaged")));
    folder_.write("frames.json", "{");
    EXPECT_THAT(folder_.read().notes, ElementsAre(HasSubstr("not an index of frames")));
    folder_.write("frames.json", R"({"frames": [{"file": "frames/frame_000000.h5", "time": 0.25, "step": 1}]})");
    const RunFiles run = folder_.read();
    EXPECT_THAT(run.particles.times, IsEmpty());
    EXPECT_THAT(run.notes, ElementsAre(HasSubstr("the frame at 0.25 s is left out")));
}

TEST_F(RunFilesOf, WithoutAFolderOrASummaryThereIsNoRun) {
    EXPECT_THAT(text_thrown<InputError>(
                    [&] { static_cast<void>(read_run_files(folder_.path() / "nowhere", RunFolder::made_frames)); }),
                AllOf(HasSubstr("nowhere"), HasSubstr("there is no such folder")));
    folder_.remove("summary.json");
    folder_.remove("scene.resolved.toml");
    EXPECT_THAT(error(), AllOf(HasSubstr("out"), HasSubstr("there is no summary.json in it, and no run.log with a "
                                                           "scene.resolved.toml of a run that was ended before")));
}

TEST_F(RunFilesOf, TheLogHasWarningsAndErrorsOfSeveralLines) {
    const LoggedRun log = logged_run(
        "2026-11-26 23:34:03 UTC  dmp 0.1.0\ndmp run valve\n\nwarning: cycle.png: blank\n  last_frame.png: blank\n"
        "warning: other\nerror: particle 7 flew away\n  Look at it.\n  And again.\n");
    EXPECT_THAT(log.warnings, ElementsAre("cycle.png: blank\nlast_frame.png: blank", "other"));
    EXPECT_EQ(log.error, "particle 7 flew away\nLook at it.\nAnd again.");
    EXPECT_EQ(logged_run("error: gone\n2026-11-26 23:34:03 UTC  dmp 0.1.0\ndmp run valve --resume\n").error, "")
        << "the run goes on";
}

TEST_F(RunFilesOf, WithoutASummaryTellTheLog) {
    folder_.remove("summary.json");
    folder_.write("measures.csv", "time [s],flux [m^3/s]\n0,1\n0.5");
    const RunFiles run = folder_.read();
    EXPECT_TRUE(run.has_no_end());
    EXPECT_THAT(run.log_text, HasSubstr("dmp run valve --resume"));
    EXPECT_THAT(run.notes, testing::Contains(HasSubstr("measures.csv is damaged"))) << "by the kill";
}

TEST_F(RunFilesOf, DamageIsNamedWithItsPlace) {
    folder_.write("summary.json", "{\n  \"title\": \"x\",\n  oops\n}");
    EXPECT_THAT(error(), AllOf(HasSubstr("summary.json:3:3"), HasSubstr("not valid JSON")));
    folder_.write("summary.json", "[1]");
    EXPECT_THAT(error(), HasSubstr("does not hold a JSON object"));
    folder_.write("summary.json", R"({"files": ["a.png", 3]})");
    EXPECT_THAT(error(), AllOf(HasSubstr("summary.json"), HasSubstr("'files[1]' is not a text")));
}

TEST_F(RunFilesOf, DamagedMeasuresAreNamedWithTheirLine) {
    folder_.write("measures.csv", "time [s],flux [m^3/s]\n0,1\n0.5,zwei\n");
    EXPECT_THAT(error(), AllOf(HasSubstr("measures.csv:3"), HasSubstr("'zwei' is not a number")));
    folder_.write("measures.csv", "time [s],flux [m^3/s]\n0,1,2\n");
    EXPECT_THAT(error(), AllOf(HasSubstr("measures.csv:2"), HasSubstr("found 3 values, expected 2")));
    folder_.write("measures.csv", "");
    EXPECT_THAT(error(), AllOf(HasSubstr("measures.csv:1"), HasSubstr("no heading")));
}

}  // namespace
}  // namespace dmp::tests::report_run_files_tests
