// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Geometries of strangers that try to run, write and read (docs/security.md): refused by their words, and harmless in
// the confined process where the words are let through.
#include <map>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "cli/commands.hpp"
#include "geometry/confinement.hpp"
#include "geometry/geometry_process.hpp"
#include "tests/end_to_end/hostile_scripts.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::hostile_geometries_tests {

namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;
using ::testing::Not;

const std::string square =
    "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\nPhysical Surface(\"water\") = {1};\n";
const std::string mesh_of_a_triangle =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"water\"\n$EndPhysicalNames\n"
    "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
    "$Elements\n4\n1 1 2 0 1 1 2\n2 1 2 0 2 2 3\n3 1 2 0 3 3 1\n4 2 2 1 1 1 2 3\n$EndElements\n";

/// The folder of a geometry, and one outside it.
class Folders {
  public:
    Folders() {
        fs::create_directory(inside());
        fs::create_directory(outside());
        case_.write("outside/secret.txt", "424242\n");
        case_.write("outside/other.geo", square);
        case_.write("outside/part.step", "ISO-10303-21;\n");
        case_.write("inside/runs.geo", "b = 2;\n\nSystemCall \"touch " + outside().string() + "/ran\";\n");
        case_.write("inside/half.geo", "Save");
        case_.write("inside/beside.pos", "View \"v\" {\n};\n");
        for (int k = 1; k < 15; ++k) {
            const std::string next = "Include \"many" + std::to_string(k + 1) + ".geo\";\n";
            case_.write("inside/many" + std::to_string(k) + ".geo", next + next);
        }
        case_.write("inside/many15.geo", "a = 1;\n");
        fs::create_symlink(outside() / "other.geo", inside() / "link.geo");
        EXPECT_EQ(mkfifo((inside() / "pipe.geo").c_str(), 0600), 0);
    }

    [[nodiscard]] fs::path inside() const { return case_.path() / "inside"; }
    [[nodiscard]] fs::path outside() const { return case_.path() / "outside"; }

    /// A file of the geometry's folder, with the path of the one outside put in.
    void write(const std::string& file, std::string text) const {
        const std::string out = outside().string();
        for (std::size_t at = 0; (at = text.find("OUT", at)) != std::string::npos; at += out.size())
            text.replace(at, 3, out);
        case_.write("inside/" + file, text);
    }

    /// All that is in both, with sizes.
    [[nodiscard]] std::map<std::string, std::uintmax_t> contents() const {
        std::map<std::string, std::uintmax_t> all;
        for (const auto& entry : fs::recursive_directory_iterator(case_.path()))
            all[entry.path().string()] = entry.is_regular_file() ? entry.file_size() : 0;
        return all;
    }
    /// The error's text with the path outside taken out again.
    [[nodiscard]] std::string with_out(std::string text) const {
        const std::string out = outside().string();
        for (std::size_t at = 0; (at = text.find(out)) != std::string::npos;) text.replace(at, out.size(), "OUT");
        return text;
    }

  private:
    CaseFolder case_;
};

class HostileGeometry : public testing::TestWithParam<Hostile> {};

TEST_P(HostileGeometry, IsRefusedWithTheWordAndItsPlace) {
    const Hostile& hostile = GetParam();
    const Folders folders;
    folders.write(hostile.file, hostile.contents);
    const auto before = folders.contents();
    const Outcome outcome = run_dmp(folders.inside(), {"inspect", hostile.file, "--unit", "mm"});
    const Outcome without_unit = outcome.errors.find("states its unit itself") == std::string::npos
                                     ? outcome
                                     : run_dmp(folders.inside(), {"inspect", hostile.file});
    EXPECT_EQ(without_unit.code, 2) << without_unit.output;
    EXPECT_THAT(folders.with_out(without_unit.errors), HasSubstr(hostile.says));
    EXPECT_EQ(folders.contents(), before);
}

TEST_P(HostileGeometry, DoesNoHarmWithoutTheCheckOfWords) {
    const Confinement offered = confinement_offered();
    if (!offered.system_calls || offered.files == 0) GTEST_SKIP() << "this machine or build cannot confine a process";
    const Hostile& hostile = GetParam();
    const Folders folders;
    folders.write(hostile.file, hostile.contents);
    const auto before = folders.contents();
    GeometryOptions options;
    options.file = (folders.inside() / hostile.file).string();
    options.trust = Trust::unchecked;
    std::string said;
    try {
        const Geometry geometry = read_geometry_in_process(
            options, {.command = {DMP_PROGRAM, dmp::cli::read_geometry_command}, .seconds = 20});
        for (const std::string& name : geometry.names()) said += name + " ";
    } catch (const Error& error) {
        said = error.what();
    }
    RecordProperty("said", said);
    EXPECT_EQ(folders.contents(), before) << said;
    EXPECT_THAT(said, Not(HasSubstr("424242")));
}

INSTANTIATE_TEST_SUITE_P(Input, HostileGeometry, testing::ValuesIn(hostile_scripts()),
                         [](const auto& hostile) { return hostile.param.name; });

TEST(HostileGeometries, AreMoreThanForty) { EXPECT_GE(hostile_scripts().size(), 40U); }

/// Files of options that gmsh does what they say, wherever it looks for them.
TEST(HostileGeometries, FilesOfOptionsAreNotRead) {
    const Folders folders;
    folders.write("square.geo", square);
    folders.write("triangle.msh", mesh_of_a_triangle);
    for (const char* name : {"square.geo.opt", "triangle.msh.opt", "part.step.opt", "box.igs.opt", ".gmshrc",
                             ".gmsh-options", "gmsh.ini", "gmshrc"})
        folders.write(name, "SystemCall \"touch OUT/ran\";\nPrintf(\"x\") > \"OUT/written\";\n");
    fs::copy_file(fs::path(DMP_SOURCE_DIR) / "tests/data/cad/box.igs", folders.inside() / "box.igs");
    const auto before = folders.contents();
    const Surroundings at_home{
        .environment = {"HOME=" + folders.inside().string(), "GMSH_HOME=" + folders.inside().string()}};
    for (const char* file : {"square.geo", "triangle.msh", "box.igs"}) {
        const Outcome outcome = run_dmp(folders.inside(), {"inspect", file}, at_home);
        EXPECT_EQ(outcome.code, 0) << file << ": " << outcome.errors;
    }
    EXPECT_EQ(folders.contents(), before);
}

TEST(HostileGeometries, NamesOfFilesAreNoCommands) {
    const Folders folders;
    for (const char* file : {"a;touch ran;.geo", "$(touch ran).geo", "`touch ran`.geo",
                             "a\nSystemCall 'touch ran';.geo", "a', line 3: b.geo", "-o.geo", "a\"b.geo"}) {
        folders.write(file, square);
        const auto before = folders.contents();
        const Outcome outcome = run_dmp(folders.inside(), {"inspect", "./" + std::string(file)});
        EXPECT_EQ(outcome.code, 0) << file << ": " << outcome.errors;
        EXPECT_EQ(folders.contents(), before);
    }
}

TEST(HostileGeometries, LinksToDevicesAndPipesAreRefused) {
    const Folders folders;
    fs::create_symlink("/dev/zero", folders.inside() / "zero.geo");
    fs::create_symlink("/dev/stdin", folders.inside() / "stdin.msh");
    for (const char* file : {"zero.geo", "stdin.msh", "pipe.geo"}) {
        const Outcome outcome = run_dmp(folders.inside(), {"inspect", file});
        EXPECT_EQ(outcome.code, 2) << file;
        EXPECT_THAT(outcome.errors, HasSubstr("cannot be read")) << file;
    }
}

struct Endless {
    const char* name;
    std::string text;
};

TEST(HostileGeometries, ThatNeverEndAreGivenUpWithWhatWasGoingOn) {
    const std::vector<Endless> all{
        {"loop", "n = 1000000; n = n * n;\nFor i In {1 : n}\n  a = i;\nEndFor\n"},
        {"sums", "a = 1;\nb = 0.00001; b = b * b;\nFor i In {1 : 2 : b}\n  a += i;\nEndFor\n"},
    };
    for (const Endless& endless : all) {
        const Folders folders;
        folders.write("part.geo", endless.text);
        GeometryOptions options;
        options.file = (folders.inside() / "part.geo").string();
        try {  // whoever waits for it runs into ctest's limit
            (void)read_geometry_in_process(options,
                                           {.command = {DMP_PROGRAM, dmp::cli::read_geometry_command}, .seconds = 2});
            ADD_FAILURE() << endless.name << " ended";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), testing::AnyOf(HasSubstr("gmsh was not done after 2 s, when it was "),
                                                     HasSubstr("gmsh crashed on it")))
                << endless.name;
        }
    }
}

TEST(HostileGeometries, ThatCannotEndAreRefusedAtOnceWithTheirPlace) {
    const Folders folders;
    for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
             {"For i In {1 : 1000000000000}\n  a = i;\nEndFor\n", "part.geo:1:10: this loop takes 1e+12 rounds"},
             {"Macro f\n  Call f;\nReturn\nCall f;\n", "part.geo:2:3: the macro 'f' has no end"},
             {square + "a[] = {1:1e12};\n", "part.geo:4:7: this list is of 1e+12 numbers"}}) {
        folders.write("part.geo", text);
        const Outcome outcome = run_dmp(folders.inside(), {"inspect", "part.geo"});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.errors, HasSubstr(says));
    }
}

/// What --trust-geometry is for; and that the refusals above are of geometries that would have done harm.
TEST(HostileGeometries, AreTrustedOnTheCommandLineOnly) {
    const Folders folders;
    folders.write("square.geo", square + "SystemCall \"touch OUT/ran\";\n");
    EXPECT_EQ(run_dmp(folders.inside(), {"inspect", "square.geo"}).code, 2);
    EXPECT_FALSE(fs::exists(folders.outside() / "ran"));
    const Outcome trusted = run_dmp(folders.inside(), {"inspect", "square.geo", "--trust-geometry"});
    EXPECT_EQ(trusted.code, 0) << trusted.errors;
    EXPECT_TRUE(fs::exists(folders.outside() / "ran"));
    folders.write("square.geo.opt", "a = 1;\n");
    const Outcome options = run_dmp(folders.inside(), {"inspect", "square.geo", "--trust-geometry"});
    EXPECT_EQ(options.code, 2);
    EXPECT_THAT(options.errors, HasSubstr("square.geo.opt: gmsh would do what this file of options says"));
    folders.write("scene.toml", "[geometry]\nfile = \"square.geo\"\ntrust = true\n");
    EXPECT_THAT(run_dmp(folders.inside(), {"mesh", "."}).errors, HasSubstr("unknown key 'trust'"));
}

TEST(HostileGeometries, WhatIsHarmlessIsStillRead) {
    const Folders folders;
    folders.write("parts.geo", "Macro side\n  w = 2;\nReturn\n");
    folders.write(
        "square.geo",
        "Include \"parts.geo\"; // its own folder\nCall side;\nDefineConstant[ h = {1, Min 0.5, Max 2, Name "
        "\"Size/h\", Label \"End\"} ];\n"
        "SetFactory('OpenCASCADE');\nMesh.MeshSizeMax = 0.1; General.Terminal = 0; Geometry.Color.Points = {0, 0, 0};\n"
        "If (h > 0.5) // If and EndIf in a comment\n  Printf(\"h is %g > 0\", h);\nEndIf\n"
        "For i In {1 : 2} Rectangle(i) = {3 * i, 0, 0, w, h}; EndFor\n"
        "Field[1] = Distance; Field[1].CurvesList = {1};\n"
        "Physical Surface(\"water\") = {1, 2};\n");
    const Outcome outcome = run_dmp(folders.inside(), {"inspect", "square.geo"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("water"));
}

TEST(HostileGeometries, ErrorsOfGmshNameTheFileThatIsIncluded) {
    const Folders folders;
    folders.write("wrong.geo", "// a comment\n\nb = ;\n");
    folders.write("square.geo", square + "Include \"wrong.geo\";\n");
    const Outcome outcome = run_dmp(folders.inside(), {"inspect", "square.geo"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("error: wrong.geo:3: gmsh cannot read the geometry: syntax error near ';'"));
}

TEST(HostileGeometries, DoctorSaysWhatHolds) {
    const Confinement offered = confinement_offered();
    const CaseFolder folder;
    EXPECT_THAT(run_dmp(folder.path(), {"doctor"}).output,
                HasSubstr(offered.system_calls && offered.files > 0
                              ? "ok    CAD reading   in a process that starts no program, writes no file (seccomp)"
                              : "warn  CAD reading"));
}

}  // namespace

}  // namespace dmp::tests::hostile_geometries_tests
