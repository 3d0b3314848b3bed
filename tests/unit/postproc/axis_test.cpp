// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/axis.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "postproc/colour_map.hpp"
#include "postproc/frame_scene.hpp"
#include "postproc/paraview_script.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::axis_tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Ticks, AreRoundAndAlike) {
    EXPECT_THAT(round_ticks(0, 1, 5).text, ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1.0"));
    EXPECT_THAT(round_ticks(-0.0014, 0.0014, 4).text, ElementsAre("-0.001", "0", "0.001"));
    EXPECT_THAT(round_ticks(1055.75, 1056.25, 4).text, ElementsAre("1055.8", "1055.9", "1056.0", "1056.1", "1056.2"));
    EXPECT_THAT(round_ticks(0, 2.2e-5, 4).text, ElementsAre("0", "0.5e-5", "1.0e-5", "1.5e-5", "2.0e-5"));
    EXPECT_THAT(round_ticks(0, 4e6, 4).text, ElementsAre("0", "1e6", "2e6", "3e6", "4e6"));
}

TEST(Ticks, OfNothingAreNone) {
    EXPECT_TRUE(round_ticks(1, 1, 5).value.empty());
    EXPECT_TRUE(round_ticks(0, std::numeric_limits<double>::infinity(), 5).value.empty());
}

TEST(Texts, AreForPeople) {
    EXPECT_EQ(round_below(0.0191), 0.01);
    EXPECT_EQ(round_below(0.05), 0.05);
    EXPECT_EQ(round_below(0.0), 0.0);
    EXPECT_EQ(printed_length(0.005, 0.005), "5 mm");
    EXPECT_EQ(printed_length(2e-6, 2e-6), "2 µm");
    EXPECT_EQ(printed_length(5e-8, 5e-8), "50 nm");
    EXPECT_EQ(printed_length(20, 20), "20 m");
    EXPECT_EQ(time_text(0.5, 4), "0.5 s");
    EXPECT_EQ(time_text(0.0005, 0.02), "0.5 ms");
    EXPECT_EQ(time_text(0, 0), "0 s");
    EXPECT_EQ(axis_label("inlet_flux", "m^2/s"), "inlet flux [m²/s]");
    EXPECT_EQ(axis_label("strain", "1"), "strain");
    EXPECT_EQ(axis_label("viscosity", "Pa*s"), "viscosity [Pa·s]");
}

TEST(ColourMap, RunsFromEndToEnd) {
    const ColourMap viridis = ColourMap::sequential(2, 4);
    EXPECT_EQ(viridis(2), (Colour{68, 1, 84}));
    EXPECT_EQ(viridis(4), (Colour{253, 231, 37}));
    EXPECT_EQ(viridis(-1), viridis(2));
    EXPECT_EQ(viridis(9), viridis(4));
    EXPECT_EQ(viridis(std::numeric_limits<double>::quiet_NaN()), colours::not_a_number);
    const ColourMap signs = ColourMap::diverging(0, 30);
    EXPECT_EQ(signs(0), (Colour{221, 221, 221}));
    EXPECT_EQ(signs(-30), (Colour{59, 76, 192}));
    EXPECT_EQ(signs(30), (Colour{180, 4, 38}));
}

TEST(ColourMap, SequentialGetsLighterAllTheWay) {
    const ColourMap viridis = ColourMap::sequential(0, 1);
    double before = -1;
    for (int k = 0; k <= 100; ++k) {
        const Colour c = viridis(k / 100.0);
        const double luma = 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue;
        EXPECT_GT(luma, before) << k;
        before = luma;
    }
}

RunFrame fluid_with(const std::string& field, const std::string& unit, std::vector<float> values) {
    RunFrame frame;
    FrameGroup fluid;
    fluid.fields = {{field, unit, 1, std::move(values)}};
    frame.fluid = fluid;
    return frame;
}

TEST(FieldRange, LeavesStraysOutAndSaysSo) {
    std::vector<float> values(5000, 1.0F);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i) / 5000;
    values[17] = 1e6F;
    FieldRange range;
    range.include(fluid_with("shear_stress", "Pa", values), "shear_stress");
    const ColourScale scale = range.scale();
    EXPECT_EQ(scale.map.low(), 0);
    EXPECT_NEAR(scale.map.high(), 1, 2e-3);
    EXPECT_TRUE(scale.beyond_high);
    EXPECT_FALSE(scale.beyond_low);
    EXPECT_EQ(scale.label, "shear stress [Pa]");
}

TEST(FieldRange, PressureIsEvenAboutZeroOverAllFrames) {
    FieldRange range;
    range.include(fluid_with("pressure", "Pa", {-1, 0, 2}), "pressure");
    range.include(fluid_with("pressure", "Pa", {-7, 0, 3}), "pressure");
    EXPECT_EQ(range.scale().map.low(), -7);
    EXPECT_EQ(range.scale().map.high(), 7);
    EXPECT_FALSE(range.missing());
}

TEST(FieldRange, ConstantAndMissingFieldsStillHaveAScale) {
    FieldRange range;
    range.include(fluid_with("density", "kg/m^3", {1000, 1000}), "density");
    EXPECT_EQ(range.scale().map.low(), 1000);
    EXPECT_GT(range.scale().map.high(), 1000);
    FieldRange none;
    none.include(fluid_with("density", "kg/m^3", {1000}), "pressure");
    EXPECT_TRUE(none.missing());
    EXPECT_FALSE(none.scale().shown);
}

TEST(ParaviewScript, KnowsTheSpacing) {
    const std::string script = paraview_script(0.0002);
    EXPECT_THAT(script, HasSubstr("spacing = 0.0002  # of the particles [m]\n"));
    EXPECT_EQ(script.find("SPACING"), std::string::npos);
    for (const char* file : {"fluid.pvd", "solid.pvd", "walls.vtp"}) EXPECT_THAT(script, HasSubstr(file));
}

}  // namespace
}  // namespace dmp::tests::axis_tests
