// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of wrong input ends with the right exit code, says where and what is wrong, and what to do.
#include <ostream>

#include <gmock/gmock.h>

#include "tests/end_to_end/program.hpp"

namespace dmp::tests::wrong_input_tests {

namespace {

struct Edit {
    std::string file, from, to;
};

struct WrongInput {
    std::string name;
    std::string base;  ///< case to start from
    std::vector<Edit> edits;
    std::vector<std::string> arguments;  ///< after "run . --dry-run"
    std::vector<std::string> says;       ///< all of these stand in the message
};

const std::string poiseuille = "verification/poiseuille";
const std::string valve = "vein_valve";
const std::string scene = "scene.toml";
const std::string cad_geometry = "channel.geo";
const std::string spacing = R"("0.05 mm")";
const std::string drive = R"("-0.1 Pa/m")";

std::vector<std::string> set(const std::string& text) { return {"--set", text}; }

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int k = 0; k < times; ++k) all += text;
    return all;
}

std::vector<WrongInput> wrong_inputs() {
    return {
        {"KeyOfAHundredThousandParts",
         poiseuille,
         {{scene, "schema = 1", "schema = 1\na" + repeated(".a", 100'000) + " = 1"}},
         {},
         {"scene.toml:3:", "a key of more than 32 parts"}},
        {"ControlCharactersInAName",
         poiseuille,
         {{scene, "name = \"wall\"", "name = \"wa\\u001b[2Jll\""}},
         {},
         {"scene.toml:20:8: part.name: found", "a name of letters, digits"}},
        {"ViscosityBeyondAnyStep",
         valve,
         {},
         set("part.blood.viscosity=\"1e30 Pa*s\""),
         {"would take 4.2e+35 steps of 9.5e-36 s, ruled by viscosity at elastic solids (", "12 days"}},
        {"DensityBeyondAnyStep",
         valve,
         {},
         set("part.blood.density=\"1e-300 kg/m^3\""),
         {"would take 1.6e+306 steps of ", "ruled by viscosity"}},
        {"FramesBeyondAnyDisk",
         poiseuille,
         {},
         set("output.every=\"1 ns\""),
         {"--set output.every=\"1 ns\": output.every: 1 s in frames 1e-09 s apart are 1e+09 frames, more than the "
          "1e+06"}},
        {"RowsBeyondAnyDisk",
         poiseuille,
         {},
         set("output.measure_every=\"1 ns\""),
         {"output.measure_every: 1 s in rows 1e-09 s apart are 1e+09 rows of measures.csv"}},
        {"LayersBeyondAnyMemory",
         poiseuille,
         {{scene, "layers = 3", "layers = 1000000"}},
         {},
         {"scene.toml:22:10: 1000000 layers of 'wall' around a geometry of", "are a lattice of 4e+12 points",
          "reaches, 3"}},
        {"SpacingFarTooFineInSpace",
         "verification/pipe",
         {},
         set("particles.spacing=\"1 nm\""),
         {"particles.spacing", "that is a lattice of 4e+17 points", "check geometry.unit"}},
        {"Syntax", poiseuille, {{scene, "schema = 1", "schema = = 1"}}, {}, {"scene.toml:2:10:", "TOML"}},
        {"KeyTwice",
         poiseuille,
         {{scene, "spacing =", "spacing = \"1 mm\"\nspacing ="}},
         {},
         {"scene.toml:12:", "spacing"}},
        {"UnknownKey",
         poiseuille,
         {{scene, "viscosity", "viscosty"}},
         {},
         {"scene.toml:17:1:", "'viscosty'", "did you mean 'viscosity'"}},
        {"UnknownTable",
         poiseuille,
         {{scene, "[particles]", "[partikles]"}},
         {},
         {"scene.toml:10:2:", "did you mean [particles]"}},
        {"MissingKey",
         poiseuille,
         {{scene, "viscosity = \"1 mPa*s\"", ""}},
         {},
         {"scene.toml:13:1:", "missing key", "viscosity"}},
        {"MissingUnit",
         poiseuille,
         {{scene, spacing, "0.05"}},
         {},
         {"scene.toml:11:11:", "missing unit", "\"0.05 mm\""}},
        {"UnknownUnit",
         poiseuille,
         {{scene, spacing, R"("0.05 furlong")"}},
         {},
         {"scene.toml:11:17:", "unknown unit 'furlong'"}},
        {"WrongDimension",
         poiseuille,
         {{scene, spacing, R"("0.05 kg")"}},
         {},
         {"scene.toml:11:11:", "(mass)", "expected a length"}},
        {"NegativeSpacing", poiseuille, {{scene, spacing, R"("-0.05 mm")"}}, {}, {"scene.toml:11:11:", "more than 0"}},
        {"NegativeDensity", poiseuille, {{scene, "1000 kg", "-1000 kg"}}, {}, {"scene.toml:16:11:", "more than 0"}},
        {"ZeroDuration",
         poiseuille,
         {{scene, "duration = \"1 s\"", "duration = \"0 s\""}},
         {},
         {"scene.toml:30:12:", "run.duration"}},
        {"WrongType",
         poiseuille,
         {{scene, "layers = 3", "layers = \"three\""}},
         {},
         {"scene.toml:22:10:", "whole number"}},
        {"UnknownKind",
         poiseuille,
         {{scene, "\"rigid\"", "\"rigit\""}},
         {},
         {"scene.toml:21:8:", "did you mean \"rigid\""}},
        {"UnknownKernel",
         poiseuille,
         {},
         set("numerics.kernel=wendland"),
         {"--set numerics.kernel=wendland:", "wendland_c2"}},
        {"OtherSchema", poiseuille, {{scene, "schema = 1", "schema = 7"}}, {}, {"scene.toml:2:10:", "schema = 1"}},
        {"ThreeDimensions",
         poiseuille,
         {{scene, "dimension = 2", "dimension = 3"}},
         {},
         {"scene.toml:4:13:", "lies in 2-D"}},
        {"PartTwice",
         poiseuille,
         {{scene, "name = \"wall\"", "name = \"water\""}},
         {},
         {"scene.toml:20:8:", "already a part called 'water'"}},
        {"FormulaUnknownName",
         poiseuille,
         {{scene, drive, "\"-0.1 Pa/m * sin(q)\""}},
         {},
         {"scene.toml:25:39:", "unknown name 'q'"}},
        {"FormulaSyntax",
         poiseuille,
         {{scene, drive, "\"-0.1 Pa/m * (2\""}},
         {},
         {"scene.toml:25:37:", "expected ')'"}},
        {"FormulaDimension",
         poiseuille,
         {{scene, drive, R"("0.1 m/s")"}},
         {},
         {"scene.toml:25:23:", "(speed)", "pressure gradient"}},
        {"DriveAlongNoPeriod",
         poiseuille,
         {{scene, "periodic = [\"x\"]", ""}},
         {},
         {"scene.toml:25:22:", "acts along x, which is not periodic", "add \"x\" to flow.periodic"}},
        {"NoDrawing",
         poiseuille,
         {{scene, cad_geometry, "chanel.geo"}},
         {},
         {"scene.toml:7:8:", "chanel.geo", "does not exist"}},
        {"DrawingSyntax",
         poiseuille,
         {{cad_geometry, "Line(1) = {1, 2};", "Line(1) = {1, 2;"}},
         {},
         {"channel.geo:18:", "syntax error"}},
        {"DrawingWithoutNames",
         poiseuille,
         {{cad_geometry, "Physical Surface(\"water\") = {1};", ""},
          {cad_geometry, "Physical Curve(\"wall\") = {1, 3};", ""}},
         {},
         {"channel.geo:", "no named groups", "Physical Surface"}},
        {"UnknownParameter",
         poiseuille,
         {},
         set("geometry.parameters.widht=\"1 mm\""),
         {"--set geometry.parameters.widht", "'width'"}},
        {"PartNotInTheDrawing",
         poiseuille,
         {{scene, "name = \"water\"", "name = \"watre\""}},
         {},
         {"scene.toml:14:8:", "nothing named 'watre'", "'water'"}},
        {"NameNoPartUses",
         poiseuille,
         {{cad_geometry, "Physical Curve(\"wall\") = {1, 3};",
           "Physical Curve(\"wall\") = {1, 3};\nPhysical Curve(\"outlet\") = {2};"}},
         {},
         {"channel.geo", "'outlet'"}},
        {"OpenFluidBoundary",
         poiseuille,
         {{cad_geometry, "(\"wall\") = {1, 3}", "(\"wall\") = {1}"}},
         {},
         {"scene.toml:14:8:", "open between"}},
        {"OpenEnds",
         poiseuille,
         {{scene, "periodic = [\"x\"]", "periodic = []"}, {scene, "pressure_gradient", "# pressure_gradient"}},
         {},
         {"scene.toml:14:8:", "flow.periodic"}},
        {"PeriodTooShort",
         poiseuille,
         {},
         set("geometry.parameters.length=\"0.1 mm\""),
         {"scene.toml:26:13:", "shorter than the kernel's support"}},
        {"WallThinnerThanTheKernel",
         poiseuille,
         {{scene, "layers = 3", "layers = 1"}},
         {},
         {"scene.toml:22:10:", "thinner than the kernel"}},
        {"ForcePerWhat",
         poiseuille,
         {{scene, "[run]", "[[force]]\nname = \"push\"\npart = \"water\"\nforce = [\"1 N\"]\n[run]"}},
         {},
         {"scene.toml:", "missing key: force.push.amount", "'total' and 'per_particle'"}},
        {"RestitutionOfMoreThanOne",
         poiseuille,
         {{scene, "[run]", "[[contact_pair]]\nparts = [\"any\", \"any\"]\nrestitution = 1.2\n[run]"}},
         {},
         {"scene.toml:", "contact_pair.restitution: found 1.2", "at most 1"}},
        {"SpheresInThePlane",
         poiseuille,
         {{scene, "[run]",
           "[[part]]\nname = \"beads\"\nkind = \"spheres\"\nradius = \"1 um\"\nmass = \"1 ng\"\n"
           "youngs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\ncentres = [[0, 0, 0]]\n[run]"}},
         {},
         {"scene.toml:", "'beads' is of spheres", "dimension = 3"}},
        {"StepInWhichContactsGainEnergy",
         "verification/impact",
         {},
         set("numerics.contact_step=\"10 us\""),
         {"numerics.contact_step", "too long", "'ball' and 'plane'", "give at most \""}},
        {"NothingMoves", poiseuille, {}, set("part.water.enabled=false"), {"nothing would move"}},
        {"LeafletShorterThanTheDrawingAllows",
         valve,
         {},
         set("geometry.parameters.leaflet_length=\"2 mm\""),
         {"vein_valve.geo:", "leaflet_length is too short"}},
        {"LeafletThinnerThanItsLayers", valve, {}, set("part.leaflets.layers=1"), {"--set part.leaflets.layers=1:"}},
        {"NegativeSpringConstants",
         valve,
         {},
         {"--set", "part.leaflets.lower_axial_stiffness=false", "--set",
          "part.leaflets.bending_stiffness=\"1e-9 N*m^2\""},
         {"scene.toml:", "negative stiffness", "axial_stiffness"}},
        {"UnknownAnchor",
         valve,
         {},
         set("part.leaflets.anchor=\"roots\""),
         {"nothing named 'roots'", "'leaflet_roots'"}},
        {"MeasureOfNoPart",
         valve,
         {{scene, "part = \"leaflets\"", "part = \"leaves\""}},
         {},
         {"scene.toml:65:8:", "no part 'leaves'"}},
        {"SetUnknownKey",
         poiseuille,
         {},
         set("particles.spacin=1"),
         {"--set particles.spacin=1:", "did you mean 'spacing'"}},
        {"SetUnknownPart", valve, {}, set("part.leaflet.layers=2"), {"no part 'leaflet'", "did you mean 'leaflets'"}},
        {"SetWithoutValue", poiseuille, {}, set("particles.spacing"), {"--set particles.spacing:", "KEY=VALUE"}},
        {"UntilWithoutUnit", poiseuille, {}, {"--until", "5"}, {"--until:", "missing unit", "\"5 s\""}},
        {"UntilOfWrongDimension", poiseuille, {}, {"--until", "0.2 m"}, {"--until:", "expected a time"}},
        {"UntilBeforeTheStart", poiseuille, {}, {"--until", "-1 s"}, {"--until:", "after 0"}},
        {"NoThreads", poiseuille, {}, {"--threads", "0"}, {"--threads"}},
        {"UnknownVectorUnit", poiseuille, {}, {"--vector-unit", "sse"}, {"'sse'", "'avx2' and 'avx512'"}},
        {"AWordTooMany", poiseuille, {}, {"s"}, {"'s'", "--help"}},
    };
}

/// GoogleTest's name for it in messages.
void PrintTo(const WrongInput& wrong, std::ostream* stream) { *stream << wrong.name; }

class Wrong : public testing::TestWithParam<WrongInput> {};

TEST_P(Wrong, EndsWithTwoAndSaysWhatWhereAndWhatToDo) {
    const auto& wrong = GetParam();
    const CaseFolder folder;
    folder.copy_case(wrong.base);
    for (const auto& edit : wrong.edits) folder.replace(edit.file, edit.from, edit.to);
    std::vector<std::string> arguments{"run", ".", "--dry-run"};
    arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());

    const auto outcome = run_dmp(folder.path(), arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.output, "");
    EXPECT_THAT(outcome.errors, testing::StartsWith("error: "));
    for (const auto& words : wrong.says) EXPECT_THAT(outcome.errors, testing::HasSubstr(words));
    EXPECT_THAT(outcome.errors, testing::ContainsRegex("\n  [^ ]")) << "there is no line that says what to do";
}

INSTANTIATE_TEST_SUITE_P(Input, Wrong, testing::ValuesIn(wrong_inputs()),
                         [](const auto& wrong) { return wrong.param.name; });

TEST(WrongPlace, NoSceneThere) {
    const CaseFolder folder;
    EXPECT_EQ(run_dmp(folder.path(), {"run", "nowhere.toml"}).code, 2);
    EXPECT_THAT(run_dmp(folder.path(), {"run", "."}).errors, testing::HasSubstr("no scene.toml"));
}

TEST(WrongPlace, OutputFolderBelowAFile) {
    const CaseFolder folder;
    folder.copy_case(poiseuille);
    const auto outcome = run_dmp(folder.path(), {"run", ".", "--out", "scene.toml/below"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, testing::HasSubstr("'scene.toml' is a file"));
}

TEST(WrongPlace, OutputIsNoDeviceAndNoFolder) {
    const CaseFolder folder;
    folder.copy_case(poiseuille);
    std::filesystem::create_symlink("/dev/null", folder.path() / "device");
    std::filesystem::create_directory(folder.path() / "taken");
    for (const std::vector<std::string>& words : {std::vector<std::string>{"escape", "--out", "device"},
                                                  {"mesh", ".", "--particles", "device"},
                                                  {"mesh", ".", "--particles", "taken"}}) {
        const auto outcome = run_dmp(folder.path(), words);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.output, "") << "it is told before the work";
        EXPECT_THAT(outcome.errors, testing::HasSubstr(": this is no file, but a "));
    }
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "device"));
}

TEST(WrongPlace, FolderForAFirstSceneIsToldBeforeTheGeometryIsRead) {
    const CaseFolder folder;
    folder.write("file", "");
    folder.write("part.geo", "this is no geometry");
    const auto outcome = run_dmp(folder.path(), {"new", "file/below", "--from", "part.geo"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, testing::HasSubstr("'file' is a file"));
}

TEST(WrongPlace, OutputFolderWithFilesOfOthersIsLeftAlone) {
    const CaseFolder folder;
    folder.copy_case(poiseuille);
    folder.write("letters/to_mother.txt", "Dear mother");
    const auto outcome = run_dmp(folder.path(), {"run", ".", "--out", "letters"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, testing::HasSubstr("--out"));
    EXPECT_EQ(folder.read("letters/to_mother.txt"), "Dear mother");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path() / "letters"), {}), 1);
}

TEST(WrongPlace, UnknownKeyToExplain) {
    const CaseFolder folder;
    const auto outcome = run_dmp(folder.path(), {"explain", "run.duraton"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, testing::HasSubstr("did you mean 'run.duration'"));
}

TEST(FullDisk, EndsWithFourAndNamesTheFile) {
    const CaseFolder folder;
    folder.copy_case(poiseuille);
    const auto outcome = run_dmp(folder.path(), {"run", ".", "--threads", "1", "--out", "out"}, {.largest_file = 4096});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.errors, testing::AllOf(testing::StartsWith("error: "), testing::HasSubstr("out/")));
}

}  // namespace

}  // namespace dmp::tests::wrong_input_tests
