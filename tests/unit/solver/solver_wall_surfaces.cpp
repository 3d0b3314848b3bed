// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Walls for spheres as triangles to look at, and frames that hold them.
#include <gtest/gtest.h>

#include "solver/output/frame_file.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/output/wall_surfaces.hpp"
#include "solver/results/frame_check.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/equal_frames.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::solver_wall_surfaces_tests {
namespace {

ParticleSpace room() {
    ParticleSpace space;
    space.dimension = 3;
    space.parts = {{"beads", PartKind::spheres}, {"slope", PartKind::rigid}, {"tube", PartKind::rigid}};
    space.wall_planes = {{1, Vec(0, 0, 1), Vec(0.6, 0, 0.8)}};
    space.wall_corners = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1), Vec(9, 9, 9)};
    space.wall_triangles = {{2, 3, 2, 1}, {2, 0, 1, 2}};
    return space;
}

const Box shown{Vec(-1, -1, -1), Vec(3, 1, 1)};

FrameGroup surfaces_of(int part, const Vec& moved = Vec::Zero()) {
    return wall_surfaces(
        "walls", room(), shown, [part](int other) { return other == part; }, [&](int) { return moved; });
}

Vec corner(const FrameGroup& group, std::size_t i) {
    return {group.position[3 * i], group.position[3 * i + 1], group.position[3 * i + 2]};
}

TEST(WallSurfaces, show_of_a_plane_a_square_as_wide_as_the_box_is_long) {
    const FrameGroup group = surfaces_of(1, Vec(0, 0, 2));
    ASSERT_EQ(group.size(), 4U);
    EXPECT_EQ(problem_with(group), "");
    EXPECT_EQ(group.triangles.size(), 6U);
    const double length = shown.extent().norm();
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR((corner(group, i) - Vec(0, 0, 3)).dot(Vec(0.6, 0, 0.8)), 0, 1e-6) << "on the plane as it is now";
        EXPECT_NEAR((corner(group, i) - corner(group, (i + 1) % 4)).norm(), length, 1e-6);
    }
}

TEST(WallSurfaces, show_triangles_with_the_corners_they_have) {
    const FrameGroup group = surfaces_of(2, Vec(0.5, 0, 0));
    ASSERT_EQ(group.size(), 4U) << "a corner that no triangle has is left out";
    ASSERT_EQ(group.triangles.size(), 6U);
    EXPECT_EQ(corner(group, static_cast<std::size_t>(group.triangles[0])), Vec(0.5, 0, 1));
    EXPECT_EQ(corner(group, static_cast<std::size_t>(group.triangles[3])), Vec(0.5, 0, 0));
    EXPECT_EQ(group.triangles[2], group.triangles[4]) << "shared";
    EXPECT_EQ(group.part, std::vector<std::int32_t>(4, 2));
    EXPECT_EQ(surfaces_of(0).size(), 0U);
}

TEST(WallSurfaces, keep_their_triangles_when_they_are_sorted_and_stored) {
    FrameGroup group = surfaces_of(2);
    const Vec first = corner(group, static_cast<std::size_t>(group.triangles[0]));
    group.id = {7, 3, 9, 1};
    sort_by_id(group);
    EXPECT_EQ(corner(group, static_cast<std::size_t>(group.triangles[0])), first);
    Frame frame;
    frame.parts = {"beads", "slope", "tube"};
    frame.groups = {group};
    const TemporaryFolder folder;
    write_frame(folder.path() / "frame.h5", frame, {});
    const Frame read = read_frame(folder.path() / "frame.h5").frame;
    expect_equal(read, frame);
    EXPECT_EQ(read.groups[0].triangles, group.triangles);
    group.triangles[1] = 4;
    EXPECT_NE(problem_with(group), "");
}

}  // namespace
}  // namespace dmp::tests::solver_wall_surfaces_tests
