// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::mesh_errors_tests {
namespace {

TEST(MeshErrors, TheTestsOwnScenesAreGood) {
    EXPECT_EQ(fault_of(channel), "no error");
    EXPECT_EQ(fault_of(flap_channel), "no error");
}

TEST(MeshErrors, APartThatTheDrawingLacks) {
    EXPECT_EQ(
        fault_of(channel.with("\"wall\"", "\"wlal\"")),
        "scene.toml:12:8: the geometry has nothing named 'wlal' (channel.geo)\n  it names 'wall' and 'water'; did "
        "you mean 'wall'?");
    EXPECT_EQ(fault_of(channel.with("\"water\"", "\"blood\"")),
              "scene.toml:7:8: the geometry has nothing named 'blood' (channel.geo)\n  it names 'wall' and 'water'");
    EXPECT_EQ(
        fault_of(flap_channel.with("\"flap\"", "\"flaps\"")),
        "scene.toml:22:8: the geometry has nothing named 'flaps' (channel.geo)\n  it names 'flap', 'root', 'wall' "
        "and 'water'; did you mean 'flap'?");
    EXPECT_EQ(fault_of(flap_channel.with("\"root\"", "\"roots\"")),
              "scene.toml:27:10: the geometry has nothing named 'roots' (channel.geo)\n  it names 'flap', 'root', "
              "'wall' and 'water'; did you mean 'root'?");
}

TEST(MeshErrors, ANameOfTheWrongKind) {
    EXPECT_EQ(fault_of(channel.with("name = \"water\"", "name = \"wall\"")
                           .with("name = \"wall\"\nkind = \"rigid\"", "name = \"water\"\nkind = \"rigid\"")),
              "scene.toml:7:8: 'wall' is a curve in the geometry, but a surface for a fluid is needed here "
              "(channel.geo)\n  it names 'wall' and 'water'");
    EXPECT_EQ(
        fault_of(
            flap_channel.with("name = \"flap\"", "name = \"root\"").with("anchor = \"root\"", "anchor = \"flap\"")),
        "scene.toml:22:8: 'root' is a point in the geometry, but a curve or a surface is needed here (channel.geo)\n  "
        "it names "
        "'flap', 'root', 'wall' and 'water'");
    EXPECT_EQ(fault_of(flap_channel.with("anchor = \"root\"", "anchor = \"water\"")),
              "scene.toml:27:10: 'water' is a surface in the geometry, but a point or a curve is needed here "
              "(channel.geo)\n  it names 'flap', 'root', 'wall' and 'water'");
}

TEST(MeshErrors, ANameThatNoPartUses) {
    EXPECT_EQ(
        fault_of(channel.with("Physical Curve(\"wall\") = {1, 3}",
                              "Physical Curve(\"wall\") = {1, 3};\nPhysical Curve(\"walls\") = {3}")),
        "scene.toml:3:8: the geometry names a curve 'walls' that no part of the scene uses (channel.geo)\n  add a "
        "[[part]] with this name (enabled = false leaves it out), or take the name out of the geometry; the scene "
        "has 'wall'");
    EXPECT_EQ(fault_of(channel.with("Physical Curve", "Physical Point(\"probe here\") = {2};\nPhysical Curve")),
              "scene.toml:3:8: the geometry names a point 'probe here' that no part of the scene uses (channel.geo)\n  "
              "add a [[part]] with this name (enabled = false leaves it out), or take the name out of the geometry");
    EXPECT_EQ(fault_of(flap_channel.with("anchor = \"root\"\n", "")),
              "scene.toml:3:8: the geometry names a point 'root' that no part of the scene uses (channel.geo)\n  add a "
              "[[part]] with this name (enabled = false leaves it out), or take the name out of the geometry");
    EXPECT_EQ(fault_of(flap_channel.with("kind = \"elastic\"", "kind = \"elastic\"\nenabled = false")), "no error");
}

TEST(MeshErrors, AnOpenFluidBoundary) {
    EXPECT_EQ(fault_of(channel.with("{1, 3};\n", "{1};\n")),
              "scene.toml:7:8: the boundary of 'water' is open between (4, 2) m and (0, 2) m: no rigid part "
              "and no periodic side closes it\n  name this curve in the geometry as part of a rigid part, or make the "
              "axis periodic (flow.periodic), or the side a plane of symmetry (flow.symmetry)");
    EXPECT_EQ(fault_of(channel.with("periodic = [\"x\"]\n", "")),
              "scene.toml:7:8: the boundary of 'water' is open between (4, 0) m and (4, 2) m: no rigid part "
              "and no periodic side closes it\n  name this curve in the geometry as part of a rigid part, or make the "
              "axis periodic (flow.periodic), or the side a plane of symmetry (flow.symmetry)");
    EXPECT_EQ(fault_of(channel.with("kind = \"rigid\"", "kind = \"rigid\"\nenabled = false")),
              "scene.toml:7:8: the boundary of 'water' is open between (0, 0) m and (4, 0) m: no rigid part and "
              "no periodic side closes it\n  name this curve in the geometry as part of a rigid part, or make the axis "
              "periodic (flow.periodic), or the side a plane of symmetry (flow.symmetry)");
    // A plane of symmetry closes its own side only.
    const Texts open_above = channel.with("{1, 3};\n", "{1};\n");
    const auto mirrored = [&](const std::string& side) {
        return fault_of(open_above.with("periodic = [\"x\"]", "periodic = [\"x\"]\nsymmetry = [\"" + side + "\"]"));
    };
    EXPECT_EQ(mirrored("y_high"), "no error");
    EXPECT_NE(mirrored("y_low").find("is open between (4, 2) m and (0, 2) m"), std::string::npos);
}

TEST(MeshErrors, PeriodicSidesThatDoNotMatch) {
    EXPECT_EQ(fault_of(channel.with("{4, 2, 0}", "{4, 1, 0}")),
              "scene.toml:7:8: the periodic sides of 'water' do not match: (0.000125, 1.0156) m is fluid, (3.9999, "
              "1.0156) m is not\n  draw both ends of the period alike, or take the axis out of flow.periodic");
    EXPECT_EQ(fault_of(channel.with("{4, 0, 0}", "{4, 0.25, 0}")),
              "scene.toml:7:8: the periodic sides of 'water' do not match: (0.125, 15.625) mm is fluid, (3.9999, "
              "0.015625) m is not\n  draw both ends of the period alike, or take the axis out of flow.periodic");
}

TEST(MeshErrors, APeriodShorterThanTheKernelReaches) {
    const Texts shortest = channel.with("{4, 0, 0}", "{0.5, 0, 0}").with("{4, 2, 0}", "{0.5, 2, 0}");
    EXPECT_EQ(fault_of(shortest), "no error");
    EXPECT_EQ(fault_of(shortest.with("[flow]", "[numerics]\nscheme = \"plain\"\nsupport = 2.5\n[flow]")
                           .with("{0.5, 0, 0}", "{0.4375, 0, 0}")
                           .with("{0.5, 2, 0}", "{0.4375, 2, 0}")),
              "no error");
    EXPECT_EQ(fault_of(shortest.with("{0.5, 0, 0}", "{0.4375, 0, 0}").with("{0.5, 2, 0}", "{0.4375, 2, 0}")),
              "scene.toml:15:13: the period along x is 437.5 mm, shorter than the kernel's support plus a spacing, 500 "
              "mm\n  draw a longer period or refine particles.spacing");
}

TEST(MeshErrors, ACurveTooShortToBend) {
    EXPECT_EQ(fault_of(flap_channel.with("{2, 1, 0}", "{2, 0.5, 0}")), "no error");  // five columns
    EXPECT_EQ(fault_of(flap_channel.with("{2, 1, 0}", "{2, 0.375, 0}")),
              "scene.toml:22:8: a curve of 'flap' is 0.375 m long, 4 columns of particles; at least 5 are needed to "
              "bend\n  refine particles.spacing or draw a longer curve");
}

TEST(MeshErrors, AClosedCurve) {
    EXPECT_EQ(fault_of(flap_channel.with("Physical Curve(\"flap\") = {10}",
                                         "Point(12) = {3, 1, 0};\nLine(11) = {11, 12};\nLine(12) = {12, 10};\n"
                                         "Physical Curve(\"flap\") = {10, 11, 12}")),
              "scene.toml:22:8: 'flap' has a closed curve, and springs run along open ones only\n  leave a gap in the "
              "curve in the geometry");
}

TEST(MeshErrors, AnAnchorThatIsNotOnTheCurve) {
    EXPECT_EQ(
        fault_of(flap_channel.with("(\"root\") = {10}", "(\"root\") = {1}")),
        "scene.toml:27:10: no point of 'root' lies on 'flap'\n  put the anchor points on the curve in the geometry");
    EXPECT_EQ(
        fault_of(flap_channel.with("Point(11)", "Point(12) = {2.07, 0.5, 0};\nPoint(11)")
                     .with("(\"root\") = {10}", "(\"root\") = {12}")),
        "scene.toml:27:10: no point of 'root' lies on 'flap'\n  put the anchor points on the curve in the geometry");
    EXPECT_EQ(fault_of(flap_channel.with("anchor = \"root\"", "anchor = \"wall\"")
                           .with("Physical Point(\"root\") = {10};\n", "")
                           .with("Point(10) = {2, 0, 0}", "Point(10) = {2, 0.1, 0}")),
              "scene.toml:27:10: no end of 'flap' lies on 'wall'\n  let the curve begin or end on it in the geometry");
}

TEST(MeshErrors, AFluidThatNoParticleFitsInto) {
    EXPECT_EQ(fault_of(channel.with("{4, 2, 0}", "{4, 0.05, 0}").with("{0, 2, 0}", "{0, 0.05, 0}")),
              "scene.toml:5:11: no particle of 'water' fits into its region at this spacing\n  refine "
              "particles.spacing, or check geometry.unit");
}

TEST(MeshErrors, AWallWithFluidOnBothSides) {
    EXPECT_EQ(fault_of(channel
                           .with("Physical Curve",
                                 "Point(10) = {1, 1, 0};\nPoint(11) = {3, 1, 0};\nLine(10) = {10, 11};\nPhysical "
                                 "Curve(\"plate\") = {10};\nPhysical Curve")
                           .with("[flow]", "[[part]]\nname = \"plate\"\nkind = \"rigid\"\n[flow]")),
              "scene.toml:15:8: no particle of the wall 'plate' fits behind its curve: there is fluid on both sides\n  "
              "draw the wall as the edge of a hole in the fluid, or refine particles.spacing");
}

TEST(MeshErrors, AWallOnTheCurveOfAnother) {
    EXPECT_EQ(fault_of(channel
                           .with("Physical Curve(\"wall\") = {1, 3};",
                                 "Physical Curve(\"wall\") = {1, 3};\nPhysical Curve(\"lid\") = {3};")
                           .with("[flow]", "[[part]]\nname = \"lid\"\nkind = \"rigid\"\n[flow]")),
              "scene.toml:15:8: no particle of the wall 'lid' is left: its curve near (2, 2) m is one of the wall "
              "'wall', too\n  name each curve in one physical group only, or leave one of the walls out");
}

TEST(MeshErrors, BodiesOnTopOfEachOther) {
    const std::string what_to_do =
        "  refine particles.spacing, or draw them further apart: an elastic solid's rows stand half a spacing beside "
        "what is drawn, so that two of them want 218.8 mm from one to the other";
    const Texts crossing =
        flap_channel.with("Physical Curve(\"flap\") = {10}",
                          "Point(20) = {1.5, 0.5, 0};\nPoint(21) = {2.5, 0.5, 0};\nLine(20) = {20, 21};\n"
                          "Physical Curve(\"flap\") = {10, 20}");
    EXPECT_EQ(fault_of(crossing),
              "scene.toml:22:8: particles of 'flap' and 'flap' stand on top of each other at (1.9375, 0.375) m\n" +
                  what_to_do);
    const Texts folded =
        flap_channel.with("Physical Curve(\"flap\") = {10}",
                          "Point(12) = {2.05, 0, 0};\nLine(11) = {11, 12};\nPhysical Curve(\"flap\") = {10, 11}");
    EXPECT_EQ(fault_of(folded),
              "scene.toml:22:8: particles of 'flap' and 'flap' stand on top of each other at (1.9375, 0.12508) m\n" +
                  what_to_do);
}

TEST(MeshErrors, SpringsThatCannotBeBothSoftAndStiff) {
    EXPECT_EQ(
        fault_of(flap_channel.with("100 N\"", "1000 N\"\nlower_axial_stiffness = false")),
        "scene.toml:25:19: the hinges of 'flap' would need a negative stiffness, -3.625 J: two rows 0.125 m apart with "
        "axial_stiffness 1000 N alone bend with EI = 3.90625 N*m^2, more than bending_stiffness 3 N*m^2\n  lower "
        "axial_stiffness to at most 768 N, refine particles.spacing, or set lower_axial_stiffness = true");
}

}  // namespace
}  // namespace dmp::tests::mesh_errors_tests
