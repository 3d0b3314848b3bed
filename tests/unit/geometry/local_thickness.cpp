// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/local_thickness.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::local_thickness_tests {
namespace {

TEST(LocalThickness, of_a_box_is_between_its_sides) {
    const LocalThickness found = local_thickness(box({0, 0, 0}, {3, 2, 1}), 10);
    EXPECT_NEAR(found.area, 22, 1e-13);
    EXPECT_EQ(found.samples.size(), 12U);
    EXPECT_NEAR(found.thinnest()->thickness, 1, 1e-14);
    EXPECT_NEAR(found.share_thinner(0.99), 0, 0);
    EXPECT_NEAR(found.share_thinner(1.01), 12.0 / 22, 1e-14);
    EXPECT_NEAR(found.share_thinner(2.01), 18.0 / 22, 1e-14);
    EXPECT_NEAR(found.share_thinner(3.01), 1, 1e-14);
    for (const ThicknessSample& sample : found.samples) EXPECT_EQ(sample.slant, 0);
}

TEST(LocalThickness, of_a_wedge_is_slanted) {
    // 10 long, 3 high at its blunt end.
    TriangleSurface wedge = box({0, 0, 0}, {10, 4, 3});
    for (Vec& corner : wedge.corners)
        if (corner.x() == 0) corner.z() *= 1e-3;
    std::size_t steep = 0;
    for (const ThicknessSample& sample : local_thickness(wedge, 1).samples)
        if (std::abs(sample.slant - 0.2997) < 1e-3) ++steep;
    EXPECT_GT(steep, 100U);
}

TEST(LocalThickness, of_a_hollow_body_is_its_wall) {
    TriangleSurface hollow = box({0, 0, 0}, {10, 10, 10});
    append(hollow, box({1, 2, 2}, {8, 8, 8.5}));
    for (std::size_t t = 12; t < 24; ++t) flip(hollow, t);
    const ThicknessSample thinnest = *local_thickness(hollow, 0.5).thinnest();
    EXPECT_NEAR(thinnest.thickness, 1, 1e-13);
    EXPECT_NEAR(std::min(thinnest.position.x(), thinnest.opposite.x()), 0, 1e-13);
    EXPECT_NEAR(std::max(thinnest.position.x(), thinnest.opposite.x()), 1, 1e-13);
}

TEST(LocalThickness, finds_a_thin_place_between_large_triangles) {
    // A plate with a hollow in its middle, 0.1 above its lower side.
    TriangleSurface plate = box({0, 0, 0}, {10, 10, 1});
    append(plate, box({4.5, 4.5, 0.1}, {5.5, 5.5, 0.8}));
    for (std::size_t t = 12; t < 24; ++t) flip(plate, t);
    const LocalThickness found = local_thickness(plate, 0.4);
    EXPECT_NEAR(found.thinnest()->thickness, 0.1, 1e-14);
    EXPECT_GT(found.share_thinner(0.15), 0.005);
    EXPECT_LT(found.share_thinner(0.15), 0.015);
}

TEST(LocalThickness, of_a_ball_is_its_diameter) {
    const LocalThickness found = local_thickness(ball(16), 1);
    for (const ThicknessSample& sample : found.samples) EXPECT_NEAR(sample.thickness, 2, 0.02);
    EXPECT_EQ(found.samples.size(), 2048U);
}

TEST(LocalThickness, is_the_same_by_any_number_of_threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const LocalThickness one = local_thickness(ball(16), 0.05);
    omp_set_num_threads(3);
    const LocalThickness three = local_thickness(ball(16), 0.05);
    omp_set_num_threads(before);
    EXPECT_EQ(one.area, three.area);
    ASSERT_EQ(one.samples.size(), three.samples.size());
    for (std::size_t k = 0; k < one.samples.size(); ++k) {
        ASSERT_EQ(one.samples[k].position, three.samples[k].position);
        ASSERT_EQ(one.samples[k].thickness, three.samples[k].thickness);
    }
}

TEST(LocalThickness, takes_blunt_edges_for_edges) {
    TriangleSurface tetrahedron;
    tetrahedron.corners = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    tetrahedron.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    const LocalThickness found = local_thickness(tetrahedron, 0.1);
    EXPECT_GT(tetrahedron.enclosed_volume(), 0);
    EXPECT_FALSE(found.thinnest().has_value());
    EXPECT_THROW(local_thickness(tetrahedron, 0), std::invalid_argument);
}

}  // namespace
}  // namespace dmp::tests::local_thickness_tests
