// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/thickened_sheet.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/surface_edges.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::thickened_sheet_tests {
namespace {

const auto nowhere = [](const Vec&, const Vec&) { return false; };

/// 2 x 1 in the plane z = 0, the second triangle facing down.
TriangleSurface flat() {
    TriangleSurface sheet;
    sheet.corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 3, 2}};
    return sheet;
}

TEST(ThickenedSheet, is_closed_and_faces_outward) {
    const TriangleSurface body = thickened_sheet(flat(), 0.5, nowhere);
    EXPECT_TRUE(count_edges(body).closed());
    EXPECT_NEAR(body.enclosed_volume(), 2 * 1 * 0.5, 1e-15);
    EXPECT_NEAR(body.area(), 2 * 2 + 6 * 0.5, 1e-14);
}

TEST(ThickenedSheet, is_open_where_it_is_held) {
    const TriangleSurface body =
        thickened_sheet(flat(), 0.5, [](const Vec& a, const Vec& b) { return a.x() == 0 && b.x() == 0; });
    EXPECT_EQ(count_edges(body).open, 4U);
    EXPECT_NEAR(body.area(), 2 * 2 + 5 * 0.5, 1e-14);
}

TEST(ThickenedSheet, follows_a_bend) {
    // Half a tube of radius 3 and length 1, whose copies are tubes of radius 3.2 and 2.8.
    constexpr int around = 200;
    TriangleSurface tube;
    for (int k = 0; k <= around; ++k) {
        const double angle = std::numbers::pi * k / around;
        for (const double z : {0.0, 1.0}) tube.corners.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), z);
        if (k == 0) continue;
        const int at = 2 * k;
        tube.triangles.push_back({at - 2, at, at - 1});
        tube.triangles.push_back({at, at + 1, at - 1});
    }
    const TriangleSurface body = thickened_sheet(tube, 0.4, nowhere);
    EXPECT_TRUE(count_edges(body).closed());
    EXPECT_NEAR(body.enclosed_volume(), std::numbers::pi / 2 * (3.2 * 3.2 - 2.8 * 2.8), 1e-3);
}

}  // namespace
}  // namespace dmp::tests::thickened_sheet_tests
