// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mid_surface.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::mid_surface_tests {
namespace {

using ::testing::HasSubstr;

TEST(MidSurface, of_a_plate_lies_half_way_between_its_faces) {
    const SheetSearch found = mid_surface(box({0, 0, 0}, {10, 8, 0.5}), 1);
    ASSERT_TRUE(found.sheet) << found.problem;
    EXPECT_NEAR(found.sheet->thickness, 0.5, 1e-14);
    EXPECT_NEAR(found.sheet->least, 0.5, 1e-14);
    EXPECT_NEAR(found.sheet->most, 0.5, 1e-14);
    EXPECT_NEAR(found.sheet->surface.area(), 80, 1e-12);
    for (const Vec& corner : found.sheet->surface.corners) EXPECT_NEAR(corner.z(), 0.25, 1e-14);
}

TEST(MidSurface, of_two_plates_is_two_sheets_and_of_a_hollow_body_is_closed) {
    TriangleSurface plates = box({0, 0, 0}, {10, 8, 0.5});
    append(plates, box({0, 0, 4}, {10, 8, 4.5}));
    const SheetSearch two = mid_surface(plates, 1);
    ASSERT_TRUE(two.sheet) << two.problem;
    EXPECT_NEAR(two.sheet->surface.area(), 160, 1e-12);
    TriangleSurface hollow = box({0, 0, 0}, {10, 10, 10});
    append(hollow, box({0.2, 0.2, 0.2}, {9.8, 9.8, 9.8}));
    for (std::size_t t = 12; t < 24; ++t) flip(hollow, t);
    const SheetSearch shell = mid_surface(hollow, 1);
    ASSERT_TRUE(shell.sheet) << shell.problem;
    EXPECT_NEAR(shell.sheet->thickness, 0.2, 1e-13);
    EXPECT_EQ(shell.sheet->surface.triangles.size(), 12U);
}

/// A plate whose upper face is slanted: its thickness goes from `thin` to `thick` along x.
TriangleSurface wedge(double thin, double thick) {
    TriangleSurface body = box({0, 0, 0}, {10, 8, 1});
    for (Vec& corner : body.corners)
        if (corner.z() > 0) corner.z() = corner.x() > 0 ? thick : thin;
    return body;
}

TEST(MidSurface, other_bodies_are_refused_with_the_reason_and_a_place) {
    const SheetSearch bar = mid_surface(box({0, 0, 0}, {10, 0.5, 0.4}), 1);
    EXPECT_FALSE(bar.sheet);
    EXPECT_EQ(bar.problem, "its faces are not two that are opposite each other");
    EXPECT_NEAR(bar.thickness, 0.4, 1e-14);
    EXPECT_EQ(mid_surface(box({0, 0, 0}, {3, 2, 1}), 0.5).problem,
              "most of its surface has nothing opposite that is so near");
    const SheetSearch slanted = mid_surface(wedge(0.2, 0.8), 1);
    EXPECT_FALSE(slanted.sheet);
    EXPECT_EQ(slanted.problem, "its thickness is not nearly the same everywhere");
    EXPECT_LT(std::min(slanted.thickness, std::abs(slanted.thickness - 1)), 0.25);
    const SheetSearch even = mid_surface(wedge(0.45, 0.55), 1);
    ASSERT_TRUE(even.sheet) << even.problem;
    EXPECT_NEAR(even.sheet->thickness, 0.5, 0.01);
}

}  // namespace
}  // namespace dmp::tests::mid_surface_tests
