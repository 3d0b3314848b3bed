// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/checked_script.hpp"

#include <filesystem>

#include <gmock/gmock.h>

#include "temporary_geometry.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::checked_script_tests {
namespace {

using ::testing::HasSubstr;

class CheckedScripts : public GeometryFileTest {
  protected:
    [[nodiscard]] CheckedScript checked(const std::string& text) const { return CheckedScript(write("d.geo", text)); }
    [[nodiscard]] std::string place(const CheckedScript& script, int line) const {
        return script.written_at(line).text().substr(path("").size());
    }
};

TEST_F(CheckedScripts, KeepTheirTokensAndLoseTheirComments) {
    EXPECT_EQ(checked("a=1.e5;// b\n\n  c += .5 ; /* d\n */ e() = {1:3}; \"//\"").text(),
              "a=1.e5;\nc += .5 ;\ne() = {1:3}; \"//\"\n");
    EXPECT_EQ(checked("").text(), "\n");
}

TEST_F(CheckedScripts, KnowWhereTheirLinesWereWritten) {
    (void)write("other.geo", "// nothing\n\nb = 2;\nc = 3;");
    const CheckedScript script = checked("// first\na = 1;\n\nInclude \"other.geo\"; d = 4;\ne = 5;\n");
    EXPECT_EQ(script.text(), "a = 1;\nb = 2;\nc = 3;\nd = 4;\ne = 5;\n");
    EXPECT_EQ(place(script, 1), "d.geo:2");
    EXPECT_EQ(place(script, 2), "other.geo:3");
    EXPECT_EQ(place(script, 3), "other.geo:4");
    EXPECT_EQ(place(script, 4), "d.geo:4");
    EXPECT_EQ(place(script, 5), "d.geo:5");
    EXPECT_EQ(place(script, 99), "d.geo:5");
}

TEST_F(CheckedScripts, ReadThePathThatWasChecked) {
    // With the link followed a/x.geo, which lies in the folder; without it, a file above the folder.
    namespace fs = std::filesystem;
    fs::create_directories(path("in/a/b/c"));
    fs::create_directory_symlink(path("in/a/b/c"), path("in/link"));
    (void)write("x.geo", "above = 1;\n");
    (void)write("in/a/x.geo", "inside = 1;\n");
    EXPECT_EQ(CheckedScript(write("in/d.geo", "Include \"link/../../x.geo\";\n")).text(), "inside = 1;\n");
}

TEST_F(CheckedScripts, JumpToBeginningsOfLinesOnly) {
    // gmsh notes the end of what it has read as the place to come back to.
    EXPECT_EQ(checked("For i In {1 : 2} a = 1; EndFor Macro f b = 2; Return Call f; c = 3;").text(),
              "For i In {1 : 2}\na = 1; EndFor Macro f\nb = 2; Return Call f;\nc = 3;\n");
}

TEST_F(CheckedScripts, MayUseWordsOfCommandsAsNames) {
    EXPECT_EQ(checked("Save = 1; Print = Save + 2; Physical Surface(\"Save\") = {Save};\n").text(),
              "Save = 1; Print = Save + 2; Physical Surface(\"Save\") = {Save};\n");
}

TEST_F(CheckedScripts, MayCompareWhatTheyPrint) {
    EXPECT_EQ(checked("Printf(\"%g\", (a > 1) > 2);\n").text(), "Printf(\"%g\", (a > 1) > 2);\n");
    EXPECT_THAT(text_thrown<InputError>([&] { (void)checked("Printf(\"%g\", (a > 1)) > \"b\";\n"); }),
                HasSubstr("d.geo:1:1: 'Printf' would write what it says into a file"));
}

TEST_F(CheckedScripts, MayHaveStructuresAndHarmlessOptions) {
    (void)checked(
        "Struct S [ a 1 ];\nb = S.a;\nMesh.Algorithm = 6; Mesh.MshFileVersion = 2.2;\nGeneral.Terminal = "
        "1;\nMesh.Color.Lines = Red;\n");
    for (const char* line : {"Struct Solver [ a 1 ];\nSolver.Executable0 = \"x\";\n",
                             "Geometry.DoubleClickedPointCommand = \"x\";\n", "T.a = 1;\n", "View[0].Visible = 0;\n"})
        EXPECT_THAT(text_thrown<InputError>([&] { (void)checked(line); }), HasSubstr("set or read an option")) << line;
}

}  // namespace
}  // namespace dmp::tests::checked_script_tests
