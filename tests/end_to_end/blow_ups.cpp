// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that diverge: how they end, what they say, and that what they leave can be looked at.
#include <regex>

#include <gmock/gmock.h>

#include "postproc/read_frames.hpp"
#include "tests/end_to_end/small_valve.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::blow_ups_tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;

class BlowUp : public SmallValve {
  protected:
    /// The last frame, as ParaView would open it, holds the particle that the message names, at the place it names.
    void expect_snapshot_of(const std::string& message, const std::string& out) const {
        std::smatch words;
        const std::regex particle(
            "step ([0-9]+): particle ([0-9]+) of 'blood' at \\(([-+.e0-9]+) m, ([-+.e0-9]+) m\\)");
        ASSERT_TRUE(std::regex_search(message, words, particle)) << message;
        const auto series = read_series(folder_.path() / out / "fluid.pvd");
        ASSERT_FALSE(series.empty());
        const Frame frame = read_frame(series.back().file, "fluid").frame;
        EXPECT_EQ(frame.step, std::stol(words[1]));
        const FrameGroup& fluid = frame.groups.front();
        const auto found = std::ranges::find(fluid.id, std::stol(words[2]));
        ASSERT_NE(found, fluid.id.end());
        const auto index = found - fluid.id.begin();
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_NEAR(fluid.position[3 * index + axis], std::stod(words[3 + axis]), 1e-7);
    }
};

TEST_F(BlowUp, FromTooLongAStepNamesTheStep) {
    const auto ended = run("out", {"--set", "numerics.scheme=plain", "--set", "numerics.step_factor=1", "--set",
                                   "numerics.shifting=0", "--set", "contact.range=0"});
    ASSERT_EQ(ended.code, 3) << ended.errors;
    EXPECT_THAT(ended.errors,
                AllOf(HasSubstr("speed "), HasSubstr("likely cause: numerics.step_factor = 1 is too large")));
    expect_snapshot_of(ended.errors, "out");
}

TEST_F(BlowUp, FromTooStrongADriveNamesTheSpeed) {
    const auto ended =
        run("out", {"--set", "flow.pressure_gradient=[\"-77090 Pa/m * cos(2*pi*t / 4 s)\", 0]", "--until", "0.5 s"});
    ASSERT_EQ(ended.code, 3) << ended.errors;
    EXPECT_THAT(ended.errors, AllOf(HasSubstr("sound speed 3 m/s"), HasSubstr("likely cause: numerics.sound_speed")));
    expect_snapshot_of(ended.errors, "out");
}

TEST_F(BlowUp, FromAFormulaThatGivesNoNumberNamesIt) {
    const auto ended = run("out", {"--set", "flow.pressure_gradient=[\"-1056 Pa/m * sqrt(0.0151 - t / 1 s)\", 0]"});
    ASSERT_EQ(ended.code, 3) << ended.errors;
    EXPECT_THAT(ended.errors, AllOf(HasSubstr("is not finite"),
                                    HasSubstr("likely causes: flow.pressure_gradient gives no number at that time")));
    const auto series = read_series(folder_.path() / "out/fluid.pvd");
    ASSERT_FALSE(series.empty());
    EXPECT_GT(read_frame(series.back().file, "fluid").frame.time, 0.0151);
}

TEST_F(BlowUp, FromAWallWhoseMotionIsNoNumberNamesIt) {
    const auto ended =
        run("out", {"--set", "part.wall.surface_velocity=[\"0 m/s / (t < 0.01 s ? 1 : 0)\", 0]", "--until", "0.1 s"});
    ASSERT_EQ(ended.code, 3) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr("part.wall.surface_velocity gives no number at that time"));
}

TEST_F(BlowUp, FromAHoleInTheDrawnWallIsRefusedBeforehand) {
    folder_.replace("vein_valve.geo", "Line(20) = {20, 21};",
                    "Point(26) = {-0.030, -half_width, 0};\nPoint(27) = {-0.027, -half_width, 0};\n"
                    "Line(20) = {20, 26};\nLine(26) = {26, 27};\nLine(27) = {27, 21};");
    folder_.replace("vein_valve.geo", "Curve Loop(1) = {20, 21", "Curve Loop(1) = {20, 26, 27, 21");
    folder_.replace("vein_valve.geo", "13, 20, 21, 22, 23};", "13, 20, 27, 21, 22, 23};");
    const auto refused = run("out");
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("the boundary of 'blood' is open between (-30, -4) mm and (-27, -4) mm"));
}

}  // namespace

}  // namespace dmp::tests::blow_ups_tests
