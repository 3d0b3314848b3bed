// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Wrong study files: the exact place, what was found and what to do.
#include <ostream>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::study_errors_tests {
namespace {

/// good_study with `found` replaced, and the message it must give.
struct StudyFault {
    const char* name;
    const char* found;
    const char* replacement;
    const char* message;
};

void PrintTo(const StudyFault& fault, std::ostream* stream) { *stream << fault.name; }

class BadStudy : public testing::TestWithParam<StudyFault> {};

TEST_P(BadStudy, SaysWhereWhatAndWhatToDo) {
    EXPECT_EQ(study_fault(study_with(GetParam().found, GetParam().replacement)), GetParam().message);
}

constexpr const char* values = "values = [\"1e-6 N*m^2\", \"3e-6 N*m^2\"]";
constexpr const char* range = "range = { from = \"0.1 mm\", to = \"0.4 mm\", steps = 3, scale = \"log\" }";

INSTANTIATE_TEST_SUITE_P(
    Study, BadStudy,
    testing::ValuesIn(std::vector<StudyFault>{
        {"misspelt_key", "[[vary]]\nkey = \"part", "[[vary]]\nkye = \"part",
         "study.toml:4:1: unknown key 'kye' in [[vary]]\n"
         "  did you mean 'key'?"},
        {"misspelt_table", "[[result]]", "[[reslt]]",
         "study.toml:11:3: unknown key 'reslt'\n"
         "  did you mean 'result'?"},
        {"single_brackets",
         "[[vary]]\nkey = \"part.leaflets.bending_stiffness\"\nvalues = [\"1e-6 N*m^2\", \"3e-6 N*m^2\"]\n\n[[vary]]",
         "[vary]",
         "study.toml:3:1: 'vary' is a table, expected a list of tables\n"
         "  write [[vary]] with double brackets, once for each vary"},
        {"no_scene", "scene = \"scene.toml\"", "",
         "study.toml: missing key: scene\n"
         "  add 'scene': the scene's file, relative to the study's folder"},
        {"missing_scene_file", "scene.toml", "scenes.toml",
         "study.toml:1:9: scene: there is no 'scenes.toml'\n"
         "  give the scene's file, or its folder, relative to the folder of the study"},
        {"unknown_scene_key", "particles.spacing", "particles.spcing",
         "study.toml:8:7: unknown key 'particles.spcing'\n"
         "  did you mean 'spacing' in [particles]?"},
        {"part_that_the_scene_lacks", "part.leaflets", "part.leaflet",
         "study.toml:4:7: the scene has no part 'leaflet'\n"
         "  did you mean 'leaflets'?"},
        {"wrong_dimension", "3e-6 N*m^2", "3e-6 N",
         "study.toml:5:25: part.leaflets.bending_stiffness: found \"3e-6 N\" (force), expected a bending stiffness "
         "such as \"3e-6 N*m^2\"\n"
         "  give a bending stiffness for bending_stiffness"},
        {"number_without_unit", "\"3e-6 N*m^2\"", "3e-6",
         "study.toml:5:25: missing unit: bending_stiffness = 3e-6, expected a bending stiffness such as \"3e-6 "
         "N*m^2\"\n"
         "  write bending_stiffness = \"3e-6 N*m^2\", with the unit you mean"},
        {"misspelt_unit", "3e-6 N*m^2", "3e-6 N*mn^2",
         "study.toml:5:33: unknown unit 'mn' in \"3e-6 N*mn^2\"\n"
         "  did you mean 'mN'?"},
        {"value_out_of_range", "\"3e-6 N*m^2\"", "\"-1 N*m^2\"",
         "study.toml:5:25: part.leaflets.bending_stiffness: found \"-1 N*m^2\", expected more than 0\n"
         "  give a value that is more than 0"},
        {"empty_values", values, "values = []",
         "study.toml:5:10: vary.values: the list is empty\n"
         "  write a list such as values = [\"0.1 mm\", \"0.2 mm\"]"},
        {"values_are_no_list", values, "values = \"1e-6 N*m^2\"",
         "study.toml:5:10: vary.values: found \"1e-6 N*m^2\" (text), expected a list of values\n"
         "  write a list such as values = [\"0.1 mm\", \"0.2 mm\"]"},
        {"same_value_twice", "3e-6 N*m^2", "1 mN*mm^2\", \"1e-6 N*m^2",
         "study.toml:5:38: part.leaflets.bending_stiffness: the value \"1e-6 N*m^2\" is given twice\n"
         "  remove one of them: a grid would hold the same runs twice"},
        {"no_values", values, "",
         "study.toml:3:1: [[vary]] does not say which values its key takes\n"
         "  give exactly one of 'values', 'range', 'formula' and 'table'"},
        {"values_and_range", "range = {", "values = [\"1 mm\"]\nrange = {",
         "study.toml:7:1: [[vary]] has 'values' and 'range', expected one of them\n"
         "  give exactly one of 'values', 'range', 'formula' and 'table'"},
        {"key_twice", "particles.spacing", "part.leaflets.bending_stiffness",
         "study.toml:8:7: the key 'part.leaflets.bending_stiffness' is varied twice\n"
         "  give each key one [[vary]], or one column of a table"},
        {"empty_range", "to = \"0.4 mm\"", "to = \"0.1 mm\"",
         "study.toml:9:9: particles.spacing: the range is empty, it begins and ends at 0.1\n"
         "  give two different ends, or write values = [...] for a single one"},
        {"logarithmic_range_from_zero", "key = \"particles.spacing\"\nrange = { from = \"0.1 mm\", to = \"0.4 mm\"",
         "key = \"numerics.background_pressure\"\nrange = { from = \"0 Pa\", to = \"4 Pa\"",
         "study.toml:9:9: numerics.background_pressure: a logarithmic range from 0 to 4\n"
         "  give two ends above 0, or write scale = \"linear\""},
        {"one_step", "steps = 3", "steps = 1",
         "study.toml:9:51: vary.range.steps: found 1, expected between 2 and 1e+06\n"
         "  give a value that is between 2 and 1e+06"},
        {"range_without_steps", "steps = 3, ", "",
         "study.toml:9:9: missing key: vary.range.steps\n"
         "  add 'steps': a whole number, between 2 and 1e+06"},
        {"misspelt_scale", "scale = \"log\"", "scale = \"lgo\"",
         "study.toml:9:62: vary.range.scale: found \"lgo\", expected one of 'linear' and 'log'\n"
         "  did you mean \"log\"?"},
        {"range_of_fractions",
         "particles.spacing\"\nrange = { from = \"0.1 mm\", to = \"0.4 mm\", steps = 3, scale = \"log\" }",
         "particles.seed\"\nrange = { from = 1, to = 2, steps = 4 }",
         "study.toml:9:9: particles.seed: found 1.33333333333 (a number), expected a whole number, at least 0\n"
         "  give seed a whole number, at least 0"},
        {"threads", "particles.spacing\"\nrange = { from = \"0.1 mm\", to = \"0.4 mm\", steps = 3, scale = \"log\" }",
         "run.threads\"\nvalues = [1, 2]",
         "study.toml:8:7: 'run.threads' cannot vary: no result depends on it\n"
         "  set run.threads in the scene: it is taken for all runs of the study"},
        {"formula_that_one_run_cannot_take", "[[result]]\nname = \"opening\"",
         "[[vary]]\nkey = \"contact.range\"\nformula = \"1.5 - particles.spacing / 0.2 mm\"\n\n[[result]]\nname = "
         "\"opening\"",
         "study.toml:13:11: run 3 of 6: contact.range: found -0.5, expected at least 0\n"
         "  give a value that is at least 0"},
        {"zip_of_unlike_lengths", "scene = ", "combine = \"zip\"\nscene = ",
         "study.toml:8:1: 'particles.spacing' has 3 values, and 'part.leaflets.bending_stiffness', with which it "
         "varies together, 2\n"
         "  give both as many, or write combine = \"grid\" for each value with each"},
        {"misspelt_combine", "scene = ", "combine = \"gird\"\nscene = ",
         "study.toml:1:11: combine: found \"gird\", expected one of 'grid', 'zip' and 'latin_hypercube'\n"
         "  did you mean \"grid\"?"},
        {"samples_of_a_grid", "scene = ", "samples = 4\nscene = ",
         "study.toml:1:1: 'samples' does not apply to combine = \"grid\"\n"
         "  remove it, or write combine = \"latin_hypercube\""},
        {"hypercube_without_samples", "scene = ", "combine = \"latin_hypercube\"\nscene = ",
         "study.toml:1:1: missing key: samples\n"
         "  add 'samples': a whole number, between 1 and 1e+06"},
        {"hypercube_with_steps", "scene = ", "combine = \"latin_hypercube\"\nsamples = 10\nscene = ",
         "study.toml:11:43: steps have no meaning in a Latin hypercube\n"
         "  remove them: 'samples' at the top says how many values there are"},
        {"too_many_runs", "particles.spacing\"\nrange = {",
         "particles.seed\"\nrange = { from = 1, to = 2000, steps = 2000 }\n[[vary]]\nkey = "
         "\"particles.disorder\"\nrange = { from = 0, to = 0.4, steps = 501 }\n[[vary]]\nkey = "
         "\"particles.spacing\"\nrange = {",
         "study.toml: the study has 2004000 or more runs, more than the 1000000 that dmp makes\n"
         "  give fewer values; a Latin hypercube covers many keys with few runs (combine = \"latin_hypercube\")"},
        {"missing_csv", range, "formula = \"2 mm\"\n[[vary]]\ntable = \"no.csv\"",
         "study.toml:11:9: vary.table: there is no file 'no.csv'\n"
         "  give a CSV file relative to the folder of the study"},
        {"formula_of_a_key_that_does_not_vary", range, "formula = \"0.1 * particles.disorder\"",
         "study.toml:9:18: particles.spacing: 'particles.disorder' is not varied above\n"
         "  a formula takes keys that vary above it: 'part.leaflets.bending_stiffness'"},
        {"formula_of_another_dimension", range, "formula = \"part.leaflets.bending_stiffness\"",
         "study.toml:9:11: particles.spacing: found \"1e-06 N*m^2\" (bending stiffness), expected a length such as "
         "\"0.1 mm\"\n"
         "  give a length for spacing"},
        {"formula_with_an_error", range, "formula = \"2 mm +\"",
         "study.toml:9:11: the formula ends too early in \"2 mm +\"\n"
         "  expected a number, a name or '(' here"},
        {"measure_that_the_scene_lacks", "measure = \"tip_gap\"", "measure = \"tip_gao\"",
         "study.toml:13:11: the scene has no measure 'tip_gao'\n"
         "  did you mean 'tip_gap'?"},
        {"unknown_reduction", "reduce = \"maximum\"", "reduce = \"max\"",
         "study.toml:14:10: result.reduce: found \"max\", expected one of 'mean', 'maximum', 'minimum', 'last', "
         "'integral', 'slope', 'first_crossing', 'amplitude', 'phase', 'positive_integral' and 'negative_integral'\n"
         "  write one of these names"},
        {"column_of_a_measure_with_one", "measure = \"tip_gap\"", "measure = \"tip_gap\"\ncolumn = \"x\"",
         "study.toml:14:10: the measure 'tip_gap' of kind 'gap' has one column\n"
         "  remove 'column'"},
        {"level_missing", "level = \"2e-6 m^3/s\"", "",
         "study.toml:17:1: missing key: result.level\n"
         "  add 'level': the value to reach, in the unit of the measure"},
        {"level_of_another_quantity", "2e-6 m^3/s", "2e-6 m",
         "study.toml:21:9: result.level: found a length, but 'flux_in' is a volume flow\n"
         "  give it in m^3/s, or another unit of the same quantity"},
        {"level_of_a_mean", "reduce = \"maximum\"", "reduce = \"mean\"\nlevel = \"1 mm\"",
         "study.toml:15:1: 'level' does not apply to reduce = \"mean\", only to 'first_crossing'\n"
         "  remove it, or correct 'reduce'"},
        {"amplitude_without_period", "reduce = \"maximum\"", "reduce = \"amplitude\"",
         "study.toml:11:1: missing key: result.period\n"
         "  add 'period': a time such as \"1 s\""},
        {"period_longer_than_the_window", "reduce = \"maximum\"", "reduce = \"phase\"\nperiod = \"3 s\"",
         "study.toml:15:10: result.period: the window of 2 s is shorter than the period of 3 s\n"
         "  give a longer window, or the right period"},
        {"window_after_the_end", "from = \"2 s\"", "from = \"4 s\"",
         "study.toml:15:8: the result 'opening' is taken from 4 s until 4 s\n"
         "  let it begin before its end"},
        {"window_until_after_the_end", "from = \"2 s\"", "until = \"5 s\"",
         "study.toml:15:9: result.until: the runs end at 4 s, before 5 s\n"
         "  give a time until then, or a longer run.duration in the scene"},
        {"cycles_that_do_not_fit", "from = \"2 s\"", "every = \"1.5 s\"",
         "study.toml:15:9: result.every: the window of 4 s does not divide into parts of 1.5 s\n"
         "  change 'from', 'until' or 'every'"},
        {"too_many_cycles", "from = \"2 s\"", "every = \"1 ms\"",
         "study.toml:15:9: result.every: it makes 4000 columns of results.csv, more than 1000\n"
         "  give longer parts, or a shorter window"},
        {"cycles_shorter_than_the_period", "reduce = \"maximum\"",
         "reduce = \"phase\"\nperiod = \"1.5 s\"\nevery = \"1 s\"",
         "study.toml:16:9: result.every: parts of 1 s are shorter than the period of 1.5 s\n"
         "  give longer parts, or the right period"},
        {"result_twice", "name = \"reached\"", "name = \"opening\"",
         "study.toml:18:8: there are two results 'opening'\n"
         "  give each result a name of its own: it is a column of results.csv"},
        {"name_of_a_unit", "key = \"part.leaflets.bending_stiffness\"", "name = \"mm\"",
         "study.toml:4:8: 'mm' has a meaning in formulas already\n"
         "  choose another name: none of a unit, a function, t, x, y, z or pi"},
        {"key_and_name", "key = \"particles.spacing\"", "key = \"particles.spacing\"\nname = \"fineness\"",
         "study.toml:9:1: [[vary]] has a 'key' and a 'name', expected one of them\n"
         "  give 'key' for a key of the scene, 'name' for a value that formulas below it take"},
        {"name_twice", "key = \"particles.spacing\"", "name = \"a\"\nvalues = [1, 2]\n[[vary]]\nname = \"a\"",
         "study.toml:11:8: the key 'a' is varied twice\n"
         "  give each key one [[vary]], or one column of a table"},
        {"empty_list_of_formulas", "range = {", "formula = []\n#",
         "study.toml:9:11: vary.formula: the list is empty\n"
         "  write a formula for each value, such as formula = [\"speed*cos(angle)\", 0]"},
        {"leaves_out_what_there_is_not", "scene = \"scene.toml\"", "scene = \"scene.toml\"\nleave_out = [\"pages\"]",
         "study.toml:2:14: leave_out: found \"pages\", expected one of 'frames', 'pictures', 'page' and 'checkpoint'\n"
         "  did you mean \"page\"?"},
        {"leaves_out_no_list", "scene = \"scene.toml\"", "scene = \"scene.toml\"\nleave_out = \"page\"",
         "study.toml:2:13: leave_out: found \"page\" (text), expected a list of outputs\n"
         "  write for example leave_out = [\"pictures\", \"page\"]"},
        {"reserved_name", "name = \"opening\"", "name = \"error\"",
         "study.toml:12:8: a result may not have the name 'error'\n"
         "  give another name: results.csv has a column of this one"},
    }),
    [](const auto& tested) { return tested.param.name; });

std::string table_fault(const std::string& table) {
    return study_fault("scene = \"scene.toml\"\n[[vary]]\ntable = \"table.csv\"\n", table);
}

TEST(BadTable, SaysTheLine) {
    EXPECT_EQ(table_fault("particles.spacing [mm]\n0.1\nx\n"),
              "table.csv:3:1: expected a number in \"x mm\"\n"
              "  write a number and its unit, such as \"0.1 mm\"");
    EXPECT_EQ(table_fault("particles.spacing [mm],quality\n0.1,draft\n0.2\n"),
              "table.csv:3:1: found 1 values, expected 2\n"
              "  give each line a value for each key of the heading");
    EXPECT_EQ(table_fault("particles.spcing [mm]\n0.1\n"),
              "table.csv:1:1: unknown key 'particles.spcing'\n"
              "  did you mean 'spacing' in [particles]?");
    EXPECT_EQ(table_fault("particles.spacing [s]\n0.1\n"),
              "table.csv:2:1: particles.spacing: found \"0.1 s\" (time), expected a length such as \"0.1 mm\"\n"
              "  give a length for spacing");
    EXPECT_EQ(table_fault("particles.spacing [mm]\n"),
              "table.csv:1:1: the table has a heading only\n"
              "  write a line for each run below it");
}

TEST(BadStudy, AColumnThatTheMeasureLacksInAnyRun) {
    const Folder folder;
    Folder::write(good_scene +
                  "\n[[measure]]\nname = \"tip\"\nkind = \"displacement\"\npart = \"leaflets\"\n"
                  "point = [\"1 mm\", \"1 mm\"]\n");
    const std::string study = study_with("measure = \"tip_gap\"", "measure = \"tip\"\ncolumn = \"z\"");
    Folder::write(study, "study.toml");
    EXPECT_EQ(
        text_thrown<InputError>([] { static_cast<void>(read_study("study.toml")); }),
        "study.toml:14:10: the measure 'tip' has no column 'z', only 'x' and 'y'\n  write column = \"x\" or another of "
        "them");
    Folder::write(study_with("measure = \"tip_gap\"", "measure = \"tip\""), "study.toml");
    EXPECT_THAT(text_thrown<InputError>([] { static_cast<void>(read_study("study.toml")); }),
                testing::HasSubstr("study.toml:13:11: the measure 'tip' of kind 'displacement' has several columns"));
    // Where measures vary, only a run can tell.
    Folder::write(
        study + "\n[[vary]]\nkey = \"measure.tip.point\"\nvalues = [[\"1 mm\", \"1 mm\"], [\"2 mm\", \"1 mm\"]]\n",
        "study.toml");
    EXPECT_EQ(read_study("study.toml").results.size(), 2U);
}

TEST(BadStudyFile, IsAFileThatVariesSomething) {
    EXPECT_EQ(study_fault("scene = \"scene.toml\"\n"),
              "study.toml: the study varies nothing\n"
              "  add [[vary]] with a key and its values, such as values = [\"0.1 mm\", \"0.2 mm\"]");
    try {
        static_cast<void>(read_study("no_such_study.toml"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "no_such_study.toml: there is no such file or folder\n"
                     "  give a study file or a folder with a study.toml");
    }
}

}  // namespace
}  // namespace dmp::tests::study_errors_tests
