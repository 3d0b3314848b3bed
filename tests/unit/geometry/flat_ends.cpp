// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/flat_ends.hpp"

#include <cmath>
#include <numbers>

#include "temporary_geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::flat_ends_tests {
namespace {

using std::numbers::pi;

class EndsOf : public GeometryFileTest {
  protected:
    [[nodiscard]] std::vector<FlatEnd> ends_of(const std::string& shapes) const {
        auto options = options_for(
            write("body.geo", "SetFactory(\"OpenCASCADE\");\n" + shapes + "Physical Volume(\"body\") = Volume{:};\n"));
        options.chord_error = 0.01;
        return flat_ends(read_geometry(options).solid("body")->surface);
    }
};

TEST_F(EndsOf, ATeeHasThree) {
    const std::vector<FlatEnd> ends = ends_of(
        "Cylinder(1) = {-20, 0, 0, 40, 0, 0, 5};\nCylinder(2) = {0, 0, 0, 0, 20, 0, 4};\n"
        "BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\n");
    ASSERT_EQ(ends.size(), 3U);
    for (const int k : {0, 1}) EXPECT_NEAR(ends[k].area, 25 * pi, 0.02 * 25 * pi);
    EXPECT_NEAR((ends[0].outward + ends[1].outward).norm(), 0, 1e-9) << "one at each side";
    EXPECT_NEAR(ends[2].area, 16 * pi, 0.02 * 16 * pi);
    EXPECT_NEAR((ends[2].centre - Vec(0, 20, 0)).norm(), 0, 1e-6);
    EXPECT_NEAR((ends[2].outward - Vec(0, 1, 0)).norm(), 0, 1e-9);
    EXPECT_NEAR(ends[2].box.extent().x(), 8, 0.05);
}

TEST_F(EndsOf, ASlantedBranchHasOneToo) {
    EXPECT_EQ(ends_of("Cylinder(1) = {-20, 0, 0, 40, 0, 0, 5};\nCylinder(2) = {0, 0, 0, 12, 16, 0, 3};\n"
                      "BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\n")
                  .size(),
              3U);
}

TEST_F(EndsOf, ADuctHasTwoAndItsSidesAreNone) {
    const std::vector<FlatEnd> ends = ends_of("Box(1) = {0, 0, 0, 30, 10, 8};\n");
    ASSERT_EQ(ends.size(), 2U);
    for (const FlatEnd& end : ends) {
        EXPECT_NEAR(end.area, 80, 1e-9);
        EXPECT_NEAR(std::abs(end.outward.x()), 1, 1e-12);
    }
}

TEST_F(EndsOf, ShapesWithoutBranchesHaveNone) {
    EXPECT_TRUE(ends_of("Box(1) = {0, 0, 0, 1, 1, 1};\n").empty());
    EXPECT_TRUE(ends_of("Sphere(1) = {0, 0, 0, 1};\n").empty());
    EXPECT_TRUE(ends_of("Cylinder(1) = {0, 0, 0, 0, 0, 1, 5};\n").empty());
    EXPECT_TRUE(ends_of("Cone(1) = {0, 0, 0, 0, 0, 9, 1, 3};\n").empty()) << "its walls are not upright";
}

/// What stands in the fluid has flat faces too: they look into it.
TEST_F(EndsOf, TheTopOfAStepIsNone) {
    EXPECT_EQ(ends_of("Box(1) = {0, 0, 0, 30, 10, 10};\nBox(2) = {10, 0, 3, 2, 8, 2};\n"
                      "BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\n")
                  .size(),
              2U);
}

}  // namespace
}  // namespace dmp::tests::flat_ends_tests
