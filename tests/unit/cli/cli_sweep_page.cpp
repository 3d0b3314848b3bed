// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a study's page is told of the study (study.json).
#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/sweep/sweep_page.hpp"
#include "report/study_files.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::cli_sweep_page_tests {
namespace {

using namespace cli;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

StudyFacts facts_of(const std::string& text, const std::string& results_csv = "") {
    const Study study = study_of(text, "particles.spacing [um],deep [Pa]\n100,1000\n");
    return study_facts(study, study::Points(study), results_csv);
}

TEST(StudyFactsOf, NameKeysResultsAndPlotsInWords) {
    const StudyFacts facts = facts_of("title = \"T\"\npurpose = \"P\"\n" + good_study);
    EXPECT_EQ(facts.title, "T");
    EXPECT_EQ(facts.purpose, "P");
    EXPECT_EQ(facts.combination, "6 runs: each value with each.");
    EXPECT_EQ(facts.runs, 6U);
    ASSERT_THAT(facts.keys, SizeIs(2));
    EXPECT_EQ(facts.keys[0].values, "1e-06, 3e-06");
    EXPECT_EQ(facts.keys[1].values, "0.1, 0.2, 0.4 (of equal ratios)");
    EXPECT_EQ(facts.keys[1].unit, "mm");
    ASSERT_THAT(facts.results, SizeIs(2));
    EXPECT_EQ(facts.results[0].meaning, "maximum of tip_gap, from 2 s until the end");
    EXPECT_EQ(facts.results[1].meaning, "first_crossing of flux_in, level 2e-06 m^3/s, over the whole run");
    EXPECT_TRUE(facts.default_plots);
    ASSERT_THAT(facts.plots, SizeIs(2));
    EXPECT_EQ(facts.plots[0].key, "particles.spacing");
    EXPECT_EQ(facts.plots[0].lines_by, "part.leaflets.bending_stiffness");
    EXPECT_FALSE(facts.is_scattered);
}

TEST(StudyFactsOf, SayWhereSamplesDifferInEverything) {
    const std::string head = "scene = \"scene.toml\"\ncombine = \"latin_hypercube\"\nsamples = 50\n";
    const std::string one = "[[vary]]\nkey = \"particles.disorder\"\nrange = { from = 0, to = 0.4 }\n";
    EXPECT_FALSE(facts_of(head + one).is_scattered) << "one key alone";
    const StudyFacts facts =
        facts_of(head + one + "[[vary]]\nkey = \"particles.spacing\"\nrange = { from = \"1 mm\", to = \"2 mm\" }\n");
    EXPECT_TRUE(facts.is_scattered);
    EXPECT_EQ(facts.keys[1].values, "50 values from 1 to 2");
    EXPECT_THAT(facts.combination, HasSubstr("a Latin hypercube, seed 1"));
}

TEST(StudyFactsOf, LeaveOutPointsOfAnotherQuantityAsSoonAsARunTellsIt) {
    const std::string study =
        "scene = \"scene.toml\"\n[[vary]]\nkey = \"particles.spacing\"\nvalues = [\"0.1 mm\", \"0.2 mm\"]\n"
        "[[result]]\nname = \"deep\"\nmeasure = \"tip_gap\"\nreduce = \"last\"\n";
    const std::string plot = "[[plot]]\nresult = \"deep\"\nkey = \"particles.spacing\"\nreference = \"table.csv\"\n";
    EXPECT_THAT(study_fault(study + plot, "particles.spacing [um],deep [Pa]\n100,1000\n"),
                HasSubstr("'deep' is a pressure here, expected a length"))
        << "where the unit of the measure is known beforehand";
    // The unit of a probe depends on the field that the scene asks for.
    const Folder folder;
    Folder::write(good_scene +
                  "\n[[measure]]\nname = \"probe\"\nkind = \"probe\"\npoint = [0, \"1 mm\"]\nfield = \"pressure\"\n");
    std::string of_probe = study + plot;
    of_probe.replace(of_probe.find("tip_gap"), 7, "probe");
    Folder::write(of_probe, "study.toml");
    Folder::write("particles.spacing [um],deep [kPa]\n100,2\n", "table.csv");
    const Study read = study::read_study("study.toml");
    const study::Points points(read);
    const auto problem = [&](const std::string& heading) {
        const StudyFacts facts = study_facts(read, points, heading);
        EXPECT_THAT(facts.plots[0].references[0].x, ElementsAre(0.1)) << "in mm";
        EXPECT_THAT(facts.plots[0].references[0].y, ElementsAre(2000)) << "in Pa";
        return facts.plots[0].references[0].problem;
    };
    EXPECT_EQ(problem(""), "") << "nobody knows yet";
    EXPECT_EQ(problem("run,particles.spacing [mm],deep [Pa],exit_code,error\n"), "");
    EXPECT_EQ(problem("run,particles.spacing [mm],deep [m/s],exit_code,error\n"),
              "they are a pressure, the result is a speed");
}

TEST(SweepPage, HasEachStartInItsLog) {
    const TemporaryFolder folder;
    const Study study = study_of(good_study);
    const study::Points points(study);
    begin_sweep_page(folder.path(), study, points, TypedCommand({"dmp", "sweep", "a b"}));
    begin_sweep_page(folder.path(), study, points, TypedCommand({"dmp", "sweep", "a b", "--resume"}));
    const StudyFiles files = read_study_files(folder.path());
    ASSERT_THAT(files.log.starts, SizeIs(2));
    EXPECT_EQ(files.log.starts[0].command, "dmp sweep 'a b'");
    EXPECT_EQ(files.log.starts[1].command, "dmp sweep 'a b' --resume");
    EXPECT_THAT(files.rows, IsEmpty());
}

}  // namespace
}  // namespace dmp::tests::cli_sweep_page_tests
