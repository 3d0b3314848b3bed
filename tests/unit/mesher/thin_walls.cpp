// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Walls too thin for the fluids on their two sides, sheets thicker than their room, and sheets as the border of a
// fluid.
#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::thin_walls_tests {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// The channel with a plate from x = 1 m to 3 m, a hole in the water between these heights.
Texts plate(const std::string& low, const std::string& high) {
    return channel.with("[flow]", "[[part]]\nname = \"plate\"\nkind = \"rigid\"\n[flow]")
        .with("Plane Surface(1) = {1};",
              "Point(10) = {1, " + low + ", 0};\nPoint(11) = {3, " + low + ", 0};\nPoint(12) = {3, " + high +
                  ", 0};\nPoint(13) = {1, " + high +
                  ", 0};\nLine(10) = {10, 11};\nLine(11) = {11, 12};\nLine(12) = {12, 13};\n"
                  "Line(13) = {13, 10};\nCurve Loop(2) = {10, 11, 12, 13};\n"
                  "Plane Surface(1) = {1, 2};\nPhysical Curve(\"plate\") = {10, 11, 12, 13};");
}

std::vector<std::string> warnings_of(const Texts& texts) { return mesh_texts(texts).report.warnings; }

TEST(ThinWalls, of_one_row_are_refused_with_the_place) {
    for (const auto& [low, high] : {std::pair("1", "1.125"), std::pair("0.97", "1.15"), std::pair("1.03", "1.09")})
        EXPECT_THAT(fault_of(plate(low, high)),
                    AllOf(StartsWith("scene.toml:15:8: the wall 'plate' has a single row of particles near (1"),
                          HasSubstr("1.0625) m, with fluid on both sides: 'water' at ("),
                          HasSubstr("is behind its surface\n  draw it two spacings thick or more")));
}

TEST(ThinWalls, of_two_rows_are_taken) {
    EXPECT_THAT(warnings_of(plate("0.875", "1.125")), IsEmpty());
    EXPECT_THAT(
        warnings_of(plate("0.92", "1.0825")),
        Contains(AllOf(HasSubstr("plate: a thickness of 1.3 spacings near ("), HasSubstr("less than 2 particles"),
                       HasSubstr("with fluid on both sides, which acts on each other through it"))));
}

/// A strip beside the bottom of the channel, a quarter of a metre from it, held at its end.
Texts strip(const std::string& thickness) {
    return flap_channel.with("{2, 0, 0}", "{1, 0.25, 0}")
        .with("{2, 1, 0}", "{3, 0.25, 0}")
        .with("bending_stiffness = \"3 N*m^2\"\naxial_stiffness = \"100 N\"",
              "youngs_modulus = \"1 kPa\"\nthickness = \"" + thickness + "\"");
}

TEST(ThickSheets, that_reach_into_a_wall_are_named_with_the_place) {
    EXPECT_THAT(warnings_of(strip("0.6 m")), Contains(AllOf(StartsWith("flap: its thickness of 600 mm reaches 50 mm "
                                                                       "into 'wall' near ("),
                                                            HasSubstr(", 0.25) m"))));
    EXPECT_THAT(warnings_of(strip("0.4 m")), Not(Contains(HasSubstr("its thickness of"))));
}

TEST(ThickSheets, may_be_thick_where_they_are_held) {
    EXPECT_THAT(warnings_of(flap_channel.with("bending_stiffness = \"3 N*m^2\"\naxial_stiffness = \"100 N\"",
                                              "youngs_modulus = \"1 kPa\"\nthickness = \"0.3 m\"")),
                Not(Contains(HasSubstr("its thickness of"))));
}

TEST(ThickSheets, of_no_thickness_or_less_are_refused) {
    for (const char* thickness : {"0 m", "-1 mm"})
        EXPECT_THAT(fault_of(strip(thickness)), HasSubstr("expected more than 0"));
}

TEST(SheetsAsBorders, are_refused_with_what_to_draw) {
    EXPECT_EQ(fault_of(flap_channel.with("{1, 3};\n", "{1};\n")
                           .with("Physical Curve(\"flap\") = {10}", "Physical Curve(\"flap\") = {3}")
                           .with("Physical Point(\"root\") = {10}", "Physical Point(\"root\") = {3}")),
              "scene.toml:22:8: 'flap' is the border of 'water' near (2, 2) m, with nothing behind it: the two layers "
              "of nodes of a strip move in liquid, and close none in\n  draw it as an area of two spacings or more, "
              "with density in place of mass_per_length and thickness, or draw the liquid on both sides of it, as far "
              "as a wall");
}

}  // namespace
}  // namespace dmp::tests::thin_walls_tests
