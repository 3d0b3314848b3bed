// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The process that reads drawings. Here stand-ins play the child; tests/end_to_end has the real one.
#include "geometry/drawing_child.hpp"

#include <chrono>
#include <stdexcept>

#include <gmock/gmock.h>

#include "geometry/geometry_bytes.hpp"
#include "temporary_drawing.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp {
namespace {

using ::testing::HasSubstr;

class DrawingChildren : public testing::DrawingTest {
  protected:
    void SetUp() override {
        testing::DrawingTest::SetUp();
        drawing_ = write("d.geo", testing::unit_square + "Physical Surface(\"water\") = {1};\n");
    }

    std::string drawing_;

    /// What comes of a child that runs this shell command.
    [[nodiscard]] std::string fault(const std::string& command, double seconds = 20) const {
        return testing::text_thrown<Error>([&] {
            (void)read_drawing_apart(options_for(drawing_),
                                     {.command = {"/bin/sh", "-c", command}, .seconds = seconds});
        });
    }
};

TEST_F(DrawingChildren, HandsOnItsGeometryBitForBit) {
    Geometry geometry = read_drawing(options_for(drawing_));
    geometry.box.high.x() = 0.1 + 0.2;
    geometry.warnings = {"one", ""};
    geometry.solids.push_back({"body", {{Vec(1, 2, 3)}, {{0, 0, 0}}, 7}});
    geometry.surfaces.push_back({"side", {}, "it is open"});
    geometry.points["p"] = {Vec(0, -0.0, 1e-300)};
    geometry.unit_source = UnitSource::file;
    const std::string bytes = bytes_of(geometry);
    (void)write("answer", "G" + bytes);
    const Geometry again =
        read_drawing_apart(options_for(drawing_), {.command = {"/bin/sh", "-c", "cat " + path("answer") + " >&3"}});
    EXPECT_EQ(bytes_of(again), bytes);
    EXPECT_EQ(again.surfaces[0].why_open, "it is open");
    EXPECT_EQ(again.region("water")->area(), 1);
}

TEST_F(DrawingChildren, IsAskedForTheDrawingWithItsOptions) {
    auto options = options_for(drawing_);
    options.unit = 0.5;
    options.parameters["width"] = 3;
    options.parameter_places["width"] = {"scene.toml", 1, 2};
    (void)testing::text_thrown<Error>([&] {
        (void)read_drawing_apart(options, {.command = {"/bin/sh", "-c", "cat > " + path("request")}});
    });
    std::ifstream stream(path("request"), std::ios::binary);
    const std::string request{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    EXPECT_EQ(request, bytes_of(options));
    EXPECT_EQ(drawing_options_of(request).parameters.at("width"), 3);
    EXPECT_EQ(drawing_options_of(request).unit, 0.5);
}

TEST_F(DrawingChildren, ACrashIsAnErrorWithTheFileAndWhatHappened) {
    EXPECT_EQ(fault("kill -SEGV $$"),
              drawing_ +
                  ": the drawing cannot be read: gmsh crashed on it (Segmentation fault)\n"
                  "  Open it in the program that made it, check it there, and save it again; 'gmsh " +
                  drawing_ + "' may tell more.");
    EXPECT_THAT(fault("kill -KILL $$"), HasSubstr("gmsh crashed on it (Killed, perhaps for want of memory)"));
    EXPECT_THAT(fault("exit 3"), HasSubstr("its reader ended with code 3 and without a result"));
    EXPECT_THAT(fault("exit 0"), HasSubstr("its reader ended with code 0 and without a result"));
    EXPECT_THAT(fault("printf Gxyz >&3"), HasSubstr("its reader broke off"));
    (void)write("answer", "G" + bytes_of(read_drawing(options_for(drawing_))));
    EXPECT_THAT(fault("head -c 100 " + path("answer") + " >&3"), HasSubstr("its reader broke off"));
    EXPECT_THAT(fault("cat " + path("answer") + " >&3; kill -ABRT $$"), HasSubstr("gmsh crashed on it (Aborted)"));
}

TEST_F(DrawingChildren, AHangIsAnErrorToo) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(fault("sleep 60", 0.3), HasSubstr("gmsh was not done after 0.3 s"));
    EXPECT_THAT(fault("printf G >&3; exec sleep 60", 0.3), HasSubstr("gmsh was not done after 0.3 s"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST_F(DrawingChildren, ErrorsComeThroughWordForWord) {
    (void)write("answer", "I" + bytes_of(ErrorText{{"scene.toml", 3, 4}, "what", "to do"}));
    EXPECT_EQ(fault("cat " + path("answer") + " >&3"), "scene.toml:3:4: what\n  to do");
    EXPECT_THAT(testing::text_thrown<ResourceError>(
                    [&] { (void)read_drawing_apart(options_for(drawing_), {.command = {"/no/such/program"}}); }),
                HasSubstr("the process that reads drawings cannot be started: /no/such/program"));
}

TEST_F(DrawingChildren, FilesOfTrianglesNeedNone) {
    auto options = options_for(write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    options.unit = 1;
    EXPECT_EQ(read_drawing_apart(options, {.command = {"/no/such/program"}}).surfaces.size(), 1U);
}

TEST(GeometryBytes, CutShortOrTooLongAreRefused) {
    Geometry geometry;
    geometry.file = "a";
    const std::string bytes = bytes_of(geometry);
    EXPECT_EQ(geometry_of(bytes).file, "a");
    EXPECT_THROW((void)geometry_of(bytes + "x"), std::runtime_error);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        EXPECT_THROW((void)geometry_of(bytes.substr(0, length)), std::runtime_error);
    std::string huge = bytes;
    huge[0] = huge[1] = huge[2] = huge[3] = huge[4] = huge[5] = '\x7f';  // the length of the file's name
    EXPECT_THROW((void)geometry_of(huge), std::runtime_error);
}

}  // namespace
}  // namespace dmp
