// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What measures should be: what is read, each way to get it wrong, and the columns that measures have.
#include <cmath>

#include <gmock/gmock.h>

#include "scene/measure_columns.hpp"
#include "scene/scene_difference.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_measure_references_tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string scene_with_references = good_scene + R"toml([[measure]]
name = "flow"
kind = "probe"
point = ["1 mm", "1 mm"]

[[measure]]
name = "everywhere"
kind = "line"
from = [0, "-4 mm"]
to = [0, "4 mm"]

[[reference]]
name = "start_up"
measure = "flow"
column = "x"
formula = "20 cm/s * (1 - exp(-t / 500 ms))"
from = "100 ms"
until = "3 s"
source = "A. Author (1997)"

[[reference]]
measure = "flow"
column = "y"
formula = 0
source = "it flows along x"

[[reference]]
measure = "tip_gap"
file = "gap.csv"
source = "measured"
)toml";

std::string with(const std::string& found, const std::string& replacement) {
    std::string text = scene_with_references;
    const auto at = text.rfind(found);
    if (at == std::string::npos) throw std::logic_error("the test scene has no " + found);
    return text.replace(at, found.size(), replacement);
}

TEST(MeasureReference, IsRead) {
    const Scene scene = read_text(scene_with_references);
    ASSERT_EQ(scene.references.size(), 3U);
    const Reference& first = scene.references[0];
    EXPECT_EQ(*first.name, "start_up");
    EXPECT_EQ(first.column_name(), "flow_x");
    EXPECT_NEAR((*first.formula)(0.5), 0.2 * (1 - std::exp(-1)), 1e-16);
    EXPECT_EQ(*first.from, 0.1);
    EXPECT_EQ(*first.until, 3);
    EXPECT_EQ(*first.source, "A. Author (1997)");
    EXPECT_EQ(scene.references[1].column_name(), "flow_y");
    EXPECT_EQ((*scene.references[1].formula)(1), 0);
    EXPECT_EQ(scene.references[2].column_name(), "tip_gap");
    EXPECT_EQ(*scene.references[2].file, "gap.csv") << "read when it is wanted";
    EXPECT_EQ(*scene.references[2].from, 0);
    EXPECT_FALSE(scene.references[2].until.given());
}

TEST(MeasureReference, IsTheSameInTheResolvedScene) {
    const Scene scene = read_text(scene_with_references);
    const std::string resolved = resolved_scene(scene);
    const Scene again = read_text(resolved);
    EXPECT_EQ(resolved_scene(again), resolved);
    EXPECT_EQ(again.hash, scene.hash);
    EXPECT_EQ((*again.references[0].formula)(0.7), (*scene.references[0].formula)(0.7)) << "bit for bit";
    EXPECT_THAT(resolved, testing::HasSubstr("[[reference]]\nname = \"start_up\"\nmeasure = \"flow\"\ncolumn = \"x\"\n"
                                             "formula = \"((0.2 m/s)*(1-exp(((-t)/(0.5 s)))))\"\nfrom = \"0.1 s\"\n"
                                             "until = \"3 s\"\nsource = \"A. Author (1997)\"\n"));
}

TEST(MeasureReference, TakesOverrides) {
    EXPECT_EQ(*read_text(scene_with_references, {"reference.start_up.until=2 s"}).references[0].until, 2);
    EXPECT_EQ((*read_text(scene_with_references, {"reference.start_up.formula=7 mm/s"}).references[0].formula)(0),
              0.007);
}

TEST(MeasureReference, IsNoPartOfTheState) {
    const std::string before = resolved_scene(read_text(scene_with_references));
    const std::string now = resolved_scene(read_text(scene_with_references, {"reference.start_up.until=2 s"}));
    EXPECT_THAT(differences_in_state(before, now), IsEmpty());
    ASSERT_EQ(differences(before, now).size(), 1U);
    EXPECT_EQ(differences(before, now)[0].key, "reference.start_up.until");
}

TEST(MeasureReference, OfAPlainNumberNeedsNoUnit) {
    const std::string density =
        "[[measure]]\nname = \"density\"\nkind = \"density\"\n[[reference]]\nmeasure = \"density\"\n"
        "column = \"low\"\nsource = \"at rest\"\nformula = ";
    for (const char* one : {"1", "1.0", "\"1\"", "\"2 m / 200 cm\""})
        EXPECT_EQ((*read_text(good_scene + density + one + "\n").references[0].formula)(0), 1) << one;
}

class WrongReference : public testing::TestWithParam<Fault> {};

TEST_P(WrongReference, says_what_is_wrong) {
    EXPECT_EQ(fault_of(with(GetParam().found, GetParam().replacement)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, WrongReference,
    testing::Values(
        Fault{"unknown_measure", "measure = \"tip_gap\"", "measure = \"tipgap\"",
              "scene.toml:73:11: the scene has no measure 'tipgap'\n  did you mean 'tip_gap'?"},
        Fault{"no_such_measure", "measure = \"tip_gap\"", "measure = \"temperature\"",
              "scene.toml:73:11: the scene has no measure 'temperature'\n"
              "  its measures are 'flux_in', 'tip_gap', 'flow' and 'everywhere'"},
        Fault{"no_measure", "measure = \"tip_gap\"\n", "",
              "scene.toml:72:1: missing key: reference.measure\n"
              "  add 'measure' in [[reference]]: a name of letters, digits and '_'"},
        Fault{"no_source", "source = \"measured\"\n", "",
              "scene.toml:72:1: missing key: reference.source\n"
              "  add 'source' in [[reference]]: text"},
        Fault{"no_column", "column = \"y\"\n", "",
              "scene.toml:67:11: the measure 'flow' of kind 'probe' has several columns\n"
              "  add column = \"...\": 'x' and 'y'"},
        Fault{"unknown_column", "column = \"y\"", "column = \"z\"",
              "scene.toml:68:10: the measure 'flow' of kind 'probe' has no column 'z'\n"
              "  did you mean 'x'? Its columns are 'x' and 'y'"},
        Fault{"one_of_very_many_columns", "measure = \"flow\"\ncolumn = \"y\"",
              "measure = \"everywhere\"\ncolumn = \"y\"",
              "scene.toml:68:10: the measure 'everywhere' of kind 'line' has no column 'y'\n"
              "  Its columns are '1_x', '1_y' and so on to '20_y'"},
        Fault{"a_column_of_one", "file = \"gap.csv\"", "file = \"gap.csv\"\ncolumn = \"x\"",
              "scene.toml:75:10: the measure 'tip_gap' of kind 'gap' has one column\n  remove 'column'"},
        Fault{"twice", "column = \"y\"", "column = \"x\"",
              "scene.toml:67:11: there is already a reference for 'flow_x', at scene.toml:59:11\n  keep one of them"},
        Fault{"same_name", "measure = \"tip_gap\"", "name = \"start_up\"\nmeasure = \"tip_gap\"",
              "scene.toml:73:8: there is already a reference called 'start_up', at scene.toml:58:8\n"
              "  give each reference its own name"},
        Fault{"neither_formula_nor_file", "file = \"gap.csv\"\n", "",
              "scene.toml:73:11: the reference for 'tip_gap' has neither a formula nor a file\n  give one of them"},
        Fault{"formula_and_file", "file = \"gap.csv\"", "file = \"gap.csv\"\nformula = \"1 mm\"",
              "scene.toml:74:8: the reference for 'tip_gap' has a formula and a file\n  give one of them"},
        Fault{"another_dimension", "20 cm/s", "20 cm",
              "scene.toml:61:11: reference.start_up.formula: found \"20 cm * (1 - exp(-t / 500 ms))\" (length), "
              "expected a "
              "speed such as \"1 m/s\"\n  check the units of its factors: the whole formula must be a speed"},
        Fault{"no_unit", "formula = 0\n", "formula = 0.2\n",
              "scene.toml:69:11: missing unit: formula = 0.2, expected a speed such as \"1 m/s\"\n"
              "  write formula = \"0.2 m/s\", with the unit you mean"},
        Fault{"no_formula", "formula = 0\n", "formula = [1]\n",
              "scene.toml:69:11: reference.formula: found a list, expected a formula such as \"0.1 m/s * exp(-t / 2 "
              "s)\"\n  give formula a formula such as \"0.1 m/s * exp(-t / 2 s)\""},
        Fault{"of_position", "exp(-t / 500 ms)", "exp(-x / 1 mm)",
              "scene.toml:61:11: the reference for 'flow_x' depends on x, y or z: \"20 cm/s * (1 - exp(-x / 1 mm))\"\n"
              "  write a formula of t: a measure has one value at a time"},
        Fault{"of_no_value", "exp(-t / 500 ms)", "sqrt(2 - t / 1 s)",
              "scene.toml:61:11: the reference for 'flow_x' is no finite number at t = 2.0024 s\n"
              "  check for a division by zero, or a root or logarithm of a negative number; 'from' and 'until' leave "
              "out times at which it does not hold"},
        Fault{"ends_before_it_begins", "until = \"3 s\"", "until = \"50 ms\"",
              "scene.toml:63:9: the reference for 'flow_x' holds from 0.1 s until 0.05 s\n"
              "  let it begin before its end"}),
    name_of);

std::vector<std::string> column_names(const Scene& scene, std::size_t measure) {
    std::vector<std::string> names;
    for (const MeasureColumn& column : measure_columns(scene, scene.measures.at(measure)))
        names.push_back(column.name + " [" + column.unit + "]");
    return names;
}

TEST(MeasureColumns, HaveNamesAndUnits) {
    const Scene scene = read_text(good_scene + R"toml([[measure]]
name = "flow"
kind = "probe"
point = ["1 mm", "1 mm"]
[[measure]]
name = "load"
kind = "probe"
field = "stress"
point = ["1 mm", "1 mm"]
[[measure]]
name = "levels"
kind = "line"
field = "pressure"
from = [0, "-4 mm"]
to = [0, "4 mm"]
points = 2
[[measure]]
name = "density"
kind = "density"
)toml");
    EXPECT_THAT(column_names(scene, 0), ElementsAre("flux_in [m^3/s]"));
    EXPECT_THAT(column_names(scene, 1), ElementsAre("tip_gap [m]"));
    EXPECT_THAT(column_names(scene, 2), ElementsAre("flow_x [m/s]", "flow_y [m/s]"));
    EXPECT_THAT(column_names(scene, 3), ElementsAre("load_xx [Pa]", "load_yy [Pa]", "load_zz [Pa]", "load_xy [Pa]"));
    EXPECT_THAT(column_names(scene, 4), ElementsAre("levels_1 [Pa]", "levels_2 [Pa]"));
    EXPECT_THAT(column_names(scene, 5), ElementsAre("density_low [1]", "density_high [1]"));
}

}  // namespace
}  // namespace dmp::tests::scene_measure_references_tests
