// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The process that reads geometries. Here stand-ins play the child; tests/end_to_end has the real one.
#include "geometry/geometry_process.hpp"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "geometry/geometry_bytes.hpp"
#include "temporary_geometry.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::geometry_process_tests {
namespace {

using ::testing::HasSubstr;

class GeometryProcesses : public GeometryFileTest {
  protected:
    void SetUp() override {
        GeometryFileTest::SetUp();
        geometry_file_ = write("d.geo", unit_square + "Physical Surface(\"water\") = {1};\n");
    }

    std::string geometry_file_;

    /// What comes of a child that runs this shell command.
    [[nodiscard]] std::string fault(const std::string& command, double seconds = 20) const {
        return text_thrown<Error>([&] {
            (void)read_geometry_in_process(options_for(geometry_file_),
                                           {.command = {"/bin/sh", "-c", command}, .seconds = seconds});
        });
    }
};

TEST_F(GeometryProcesses, HandsOnItsGeometryBitForBit) {
    Geometry geometry = read_geometry(options_for(geometry_file_));
    geometry.box.high.x() = 0.1 + 0.2;
    geometry.warnings = {"one", ""};
    geometry.solids.push_back({"body", {{Vec(1, 2, 3)}, {{0, 0, 0}}, 7}});
    geometry.surfaces.push_back({"side", {}, "it is open"});
    geometry.points["p"] = {Vec(0, -0.0, 1e-300)};
    geometry.unit_source = UnitSource::file;
    const std::string bytes = bytes_of(geometry);
    (void)write("answer", "G" + bytes);
    const Geometry again = read_geometry_in_process(options_for(geometry_file_),
                                                    {.command = {"/bin/sh", "-c", "cat " + path("answer") + " >&3"}});
    EXPECT_EQ(bytes_of(again), bytes);
    EXPECT_EQ(again.surfaces[0].why_open, "it is open");
    EXPECT_EQ(again.region("water")->area(), 1);
}

TEST_F(GeometryProcesses, IsAskedForTheDrawingWithItsOptions) {
    auto options = options_for(geometry_file_);
    options.unit = 0.5;
    options.parameters["width"] = 3;
    options.parameter_locations["width"] = {"scene.toml", 1, 2};
    (void)text_thrown<Error>([&] {
        (void)read_geometry_in_process(options, {.command = {"/bin/sh", "-c", "cat > " + path("request")}});
    });
    std::ifstream stream(path("request"), std::ios::binary);
    const std::string request{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    EXPECT_EQ(request, bytes_of(options));
    EXPECT_EQ(geometry_options_from_bytes(request).parameters.at("width"), 3);
    EXPECT_EQ(geometry_options_from_bytes(request).unit, 0.5);
}

TEST_F(GeometryProcesses, ACrashIsAnErrorWithTheFileAndWhatHappened) {
    EXPECT_EQ(fault("kill -SEGV $$"),
              geometry_file_ +
                  ": the geometry cannot be read: gmsh crashed on it (Segmentation fault)\n"
                  "  Open it in the program that made it, check it there, and save it again; 'gmsh " +
                  geometry_file_ + "' may tell more.");
    EXPECT_THAT(fault("kill -KILL $$"), HasSubstr("gmsh crashed on it (Killed, perhaps for want of memory)"));
    EXPECT_THAT(fault("kill -SYS $$"), HasSubstr("it made gmsh start another program"));
    EXPECT_THAT(fault("exit 3"), HasSubstr("its reader ended with code 3 and without a result"));
    EXPECT_THAT(fault("exit 0"), HasSubstr("its reader ended with code 0 and without a result"));
    EXPECT_THAT(fault("printf Gxyz >&3"), HasSubstr("its reader broke off"));
    (void)write("answer", "G" + bytes_of(read_geometry(options_for(geometry_file_))));
    EXPECT_THAT(fault("head -c 100 " + path("answer") + " >&3"), HasSubstr("its reader broke off"));
    EXPECT_THAT(fault("cat " + path("answer") + " >&3; kill -ABRT $$"), HasSubstr("gmsh crashed on it (Aborted)"));
}

TEST_F(GeometryProcesses, AHangIsAnErrorToo) {
    EXPECT_THAT(fault("sleep 60; touch " + path("ended"), 0.3), HasSubstr("gmsh was not done after 0.3 s"));
    EXPECT_THAT(fault("printf G >&3; sleep 60; touch " + path("ended"), 0.3),
                HasSubstr("gmsh was not done after 0.3 s"));
    EXPECT_THAT(fault("printf 'Sit was reading\\000Sit was counting\\000' >&3; sleep 60", 0.3),
                HasSubstr("s, when it was counting\n"));
    EXPECT_FALSE(std::filesystem::exists(path("ended"))) << "the child was waited for";
}

TEST_F(GeometryProcesses, ALongReadingIsSpokenOf) {
    (void)write("answer", "G" + bytes_of(read_geometry(options_for(geometry_file_))));
    std::vector<std::string> stages;
    // It goes on until it has been spoken of.
    const std::string waits = "printf 'Sit was reading\\000' >&3; while [ ! -e " + path("spoken_of") +
                              " ]; do sleep 0.01; done; cat " + path("answer") + " >&3";
    (void)read_geometry_in_process(options_for(geometry_file_),
                                   {.command = {"/bin/sh", "-c", waits},
                                    .seconds = 60,
                                    .silent_seconds = 0.2,
                                    .still_reading = [&](double seconds, const std::string& stage) {
                                        EXPECT_GE(seconds, 0.2);
                                        stages.push_back(stage);
                                        (void)write("spoken_of", "");
                                    }});
    ASSERT_FALSE(stages.empty());
    EXPECT_EQ(stages.back(), "it was reading");
}

TEST_F(GeometryProcesses, AnAnswerOfNoKindOrWithoutAnEndIsRefused) {
    (void)write("answer", "Z" + bytes_of(ErrorText{{"scene.toml", 3, 4}, "what", "to do"}));
    EXPECT_THAT(fault("cat " + path("answer") + " >&3"), HasSubstr("its reader broke off"));
    EXPECT_THAT(
        text_thrown<InputError>([&] {
            (void)read_geometry_in_process(
                options_for(geometry_file_),
                {.command = {"/bin/sh", "-c", "cat /dev/zero >&3"}, .seconds = 20, .largest_answer = 1U << 20U});
        }),
        HasSubstr("what gmsh made of it takes more than 1.04858e+06 bytes"));
}

TEST_F(GeometryProcesses, ErrorsComeThroughWordForWord) {
    (void)write("answer", "I" + bytes_of(ErrorText{{"scene.toml", 3, 4}, "what", "to do"}));
    EXPECT_EQ(fault("cat " + path("answer") + " >&3"), "scene.toml:3:4: what\n  to do");
    EXPECT_THAT(text_thrown<ResourceError>([&] {
                    (void)read_geometry_in_process(options_for(geometry_file_), {.command = {"/no/such/program"}});
                }),
                HasSubstr("the process that reads geometries cannot be started: /no/such/program"));
}

TEST_F(GeometryProcesses, FilesOfTrianglesNeedNone) {
    auto options = options_for(write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    options.unit = 1;
    EXPECT_EQ(read_geometry_in_process(options, {.command = {"/no/such/program"}}).surfaces.size(), 1U);
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

TEST(GeometryBytes, OfNoGeometryAreRefused) {
    Geometry whole;
    whole.solids.push_back({"a", {{Vec(1, 2, 3)}, {{0, 0, 0}}, 0}});
    whole.curves.push_back({"b", {{{Vec(0, 0, 0)}, true}}});
    EXPECT_NO_THROW((void)geometry_of(bytes_of(whole)));
    const auto refused = [&](const auto& change) {
        Geometry geometry = whole;
        change(geometry);
        return text_thrown<std::runtime_error>([&] { (void)geometry_of(bytes_of(geometry)); });
    };
    EXPECT_THAT(refused([](Geometry& g) { g.dimension = 4; }), HasSubstr("dimensions"));
    EXPECT_THAT(refused([](Geometry& g) { g.solids[0].surface.triangles[0][1] = 1; }), HasSubstr("has not"));
    EXPECT_THAT(refused([](Geometry& g) { g.solids[0].surface.triangles[0][1] = -1; }), HasSubstr("has not"));
    EXPECT_THAT(refused([](Geometry& g) { g.solids[0].surface.corners[0].y() = NAN; }), HasSubstr("not finite"));
    EXPECT_THAT(refused([](Geometry& g) { g.curves[0].pieces[0].points[0].x() = HUGE_VAL; }), HasSubstr("not finite"));
    EXPECT_THAT(refused([](Geometry& g) { g.unit_source = static_cast<UnitSource>(7); }), HasSubstr("a unit"));
}

TEST(GeometryBytes, OfNoTruthValueAreRefused) {
    std::string bytes = bytes_of(GeometryOptions{});
    bytes[8] = 3;  // behind the file's empty name: how far it is trusted
    EXPECT_THAT(text_thrown<std::runtime_error>([&] { (void)geometry_options_from_bytes(bytes); }),
                HasSubstr("a trust that there is not"));
    bytes[8] = 0;
    bytes[12] = 2;  // then: whether there is a unit
    EXPECT_THAT(text_thrown<std::runtime_error>([&] { (void)geometry_options_from_bytes(bytes); }),
                HasSubstr("truth value"));
}

TEST(GeometryBytes, ThatStateMoreThanTheyCanHoldAreRefusedBeforeRoomIsMade) {
    const auto largest_memory = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return 1024 * usage.ru_maxrss;
    };
    const std::uint64_t count = 10'000'000;  // of solids, which would take a gigabyte
    std::string bytes = bytes_of(Geometry{}) + std::string(count, '\0');
    const std::size_t at = 8 + 4 + 6 * 8 + 8 + 8;  // file, dimension, box, regions, curves
    for (unsigned byte = 0; byte < 8; ++byte) bytes[at + byte] = static_cast<char>(count >> (8 * byte) & 0xffU);
    const long before = largest_memory();
    EXPECT_THAT(text_thrown<std::runtime_error>([&] { (void)geometry_of(bytes); }), HasSubstr("end early"));
    EXPECT_LT(largest_memory() - before, 100'000'000);
}

}  // namespace
}  // namespace dmp::tests::geometry_process_tests
