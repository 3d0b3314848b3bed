// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Lattices of solids of cells that are not the scene's.
#include "mesher/own_lattice.hpp"

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "mesher/cell_solids.hpp"
#include "mesher/turned_lattice.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::own_lattice_tests {
namespace {

using std::numbers::pi;
using ::testing::Each;
using ::testing::Eq;
using ::testing::HasSubstr;

Region area(const std::vector<Vec>& points) { return {"solid", {{points, true}}}; }
Region rectangle(const Vec& low, const Vec& high) {
    return area({low, {high[0], low[1], 0}, high, {low[0], high[1], 0}});
}
CurveSet line(const std::vector<Vec>& points) { return {"anchor", {{points, false}}}; }

/// Boxes of 1 m x 1 m from the origin on, of a space of 20 m x 10 m.
ParticleSpace space(bool periodic = false, bool mirrored = false) {
    ParticleSpace space;
    space.spacing = 1;
    space.box = {Vec(0, 0, 0), Vec(20, 10, 0)};
    space.periodic[0] = periodic;
    space.mirrored[0] = {mirrored, false};
    return space;
}
BoxLattice own(const Region& region, const CurveSet* anchor = nullptr, const ParticleSpace& in = space()) {
    return own_lattice(in, boxes_of(in, Vec(1, 1, 0)), marks_of(region, anchor, 1));
}
/// How far a coordinate is from the nearest node [steps].
double off_nodes(const BoxLattice& boxes, int axis, double x) {
    const double place = (x - boxes.origin[axis]) / boxes.step[axis];
    return std::abs(place - std::round(place));
}

TEST(OwnLattice, has_nodes_on_flat_sides) {
    // 8.2 m are 8 cells of 1.025 m; 3.5 m would be 4 cells of 0.875 m: only one of both sides can be on the lattice.
    const BoxLattice boxes = own(rectangle(Vec(3.3, 2.4, 0), Vec(11.5, 5.9, 0)));
    EXPECT_NEAR(boxes.step[0], 1.025, 1e-12);
    EXPECT_EQ(boxes.step[1], 1);
    EXPECT_LT(off_nodes(boxes, 0, 3.3) + off_nodes(boxes, 0, 11.5) + off_nodes(boxes, 1, 2.4), 1e-12);
}

TEST(OwnLattice, has_nodes_on_the_one_flat_side) {
    const BoxLattice boxes = own(area({{3, 2, 0}, {7.7, 1.3, 0}, {7.7, 6.2, 0}}));
    EXPECT_LT(off_nodes(boxes, 0, 7.7), 1e-12);
    EXPECT_EQ(boxes.step, Vec(1, 1, 0));
    EXPECT_EQ(boxes.origin[1], 0) << "no side across y";
}

TEST(OwnLattice, is_the_scenes_without_flat_sides_or_where_that_has_them_on_it) {
    std::vector<Vec> disc, turned;
    for (int n = 0; n < 100; ++n)
        disc.emplace_back(5.3 + 2 * std::cos(2 * pi * n / 100), 5.1 + 2 * std::sin(2 * pi * n / 100), 0);
    for (const Vec& corner : {Vec(0, 0, 0), Vec(8, 0, 0), Vec(8, 2, 0), Vec(0, 2, 0)})
        turned.emplace_back(3 + corner[0] * std::cos(0.3) - corner[1] * std::sin(0.3),
                            1 + corner[0] * std::sin(0.3) + corner[1] * std::cos(0.3), 0);
    for (const Region& region : {area(disc), area(turned), rectangle(Vec(2, 3, 0), Vec(9, 5, 0))}) {
        const BoxLattice boxes = own(region);
        EXPECT_EQ(boxes.origin, Vec::Zero());
        EXPECT_EQ(boxes.step, Vec(1, 1, 0));
        EXPECT_EQ(lattice_text(boxes_of(space(), Vec(1, 1, 0)), boxes), "");
    }
}

TEST(OwnLattice, has_nodes_on_its_anchor_first) {
    const Region beam = rectangle(Vec(3.3, 2, 0), Vec(11.5, 5, 0));
    // Across the beam at x = 5.1 m, longer than it: the farther end, 6.4 m from it, is on the lattice of the 6 cells
    // there only with 6.7 % more, which is too much.
    const CurveSet across = line({{5.1, 0, 0}, {5.1, 9, 0}});
    BoxLattice boxes = own(beam, &across);
    EXPECT_LT(off_nodes(boxes, 0, 5.1), 1e-12);
    EXPECT_EQ(boxes.step[0], 1);
    // With 6.2 m it is.
    boxes = own(rectangle(Vec(3.3, 2, 0), Vec(11.3, 5, 0)), &across);
    EXPECT_LT(off_nodes(boxes, 0, 5.1) + off_nodes(boxes, 0, 11.3), 1e-12);
    EXPECT_NEAR(boxes.step[0], 6.2 / 6, 1e-12);
}

/// A bar from an arc around (0, 4) m with this radius, whose ends are at y = 3 and 5 m, to x = 11.6 m.
std::pair<Region, CurveSet> bar_behind_arc(double radius) {
    std::vector<Vec> arc;
    const double half = std::asin(1 / radius);
    for (int n = 0; n <= 40; ++n) {
        const double angle = half * (1 - n / 20.0);
        arc.emplace_back(radius * std::cos(angle), 4 + radius * std::sin(angle), 0);
    }
    std::vector<Vec> outline = arc;
    outline.emplace_back(11.6, 3, 0);
    outline.emplace_back(11.6, 5, 0);
    return {area(outline), line(arc)};
}

TEST(OwnLattice, has_nodes_on_both_ends_of_a_bent_anchor_and_fills_what_is_behind_it) {
    const auto [bar, arc] = bar_behind_arc(2.5);
    const double ends = std::sqrt(2.5 * 2.5 - 1), half = std::asin(1 / 2.5);
    const LatticeMarks marks = marks_of(bar, &arc, 1);
    EXPECT_FALSE(marks.anchor[1].has_value());
    ASSERT_TRUE(marks.anchor[0].has_value());
    EXPECT_NEAR(*marks.anchor[0], ends, 1e-12);
    const BoxLattice boxes = own(bar, &arc);
    EXPECT_LT(off_nodes(boxes, 0, ends) + off_nodes(boxes, 0, 11.6), 1e-12);
    const Region behind = behind_anchor(bar, arc, 1);
    ASSERT_EQ(behind.loops.size(), 1U);
    EXPECT_NEAR(behind.area(), 2.5 * 2.5 * (half - std::sin(half) * std::cos(half)), 1e-3);
    // Where the bar is longer in its middle, nothing is left open.
    std::vector<Vec> outline = bar.loops[0].points, held = arc.pieces[0].points;
    for (std::vector<Vec>* points : {&outline, &held})
        for (std::size_t n = 0; n <= 40; ++n) (*points)[n][0] = 2 * ends - (*points)[n][0];
    EXPECT_TRUE(behind_anchor(area(outline), line(held), 1).loops.empty());
}

TEST(OwnLattice, is_the_scenes_where_nodes_have_to_stand_on_a_side_of_it) {
    const Region through = rectangle(Vec(0, 2.3, 0), Vec(20, 4.3, 0)),
                 half = rectangle(Vec(0, 2.3, 0), Vec(7.4, 4.3, 0));
    for (const auto& [region, in] :
         {std::pair{through, space(true)}, {half, space(true)}, {half, space(false, true)}}) {
        const BoxLattice boxes = own(region, nullptr, in), of_scene = boxes_of(in, Vec(1, 1, 0));
        EXPECT_EQ(boxes.origin[0], 0);
        EXPECT_EQ(boxes.step[0], 1);
        EXPECT_EQ(boxes.period[0], of_scene.period[0]);
        EXPECT_EQ(boxes.first[0], of_scene.first[0]);
        EXPECT_LT(off_nodes(boxes, 1, 2.3), 1e-12);
    }
    // Away from these sides it is free of the period.
    const BoxLattice boxes = own(rectangle(Vec(2.3, 2, 0), Vec(7.3, 4, 0)), nullptr, space(true));
    EXPECT_LT(off_nodes(boxes, 0, 2.3), 1e-12);
    EXPECT_EQ(boxes.period[0], 0);
}

TEST(OwnLattice, is_reported) {
    const BoxLattice of_scene = boxes_of(space(), Vec(1, 1, 0)),
                     boxes = own(rectangle(Vec(3.25, 2, 0), Vec(11.45, 5, 0)));
    EXPECT_THAT(lattice_text(of_scene, boxes), HasSubstr("along x shifted by 0.25 spacings and stretched by 2.5 %"));
}

/// With its low corner here, 8 m x 2 m, turned by this angle.
Region turned_bar(const Vec& at, double angle) {
    std::vector<Vec> corners;
    for (const Vec& corner : {Vec(0, 0, 0), Vec(8, 0, 0), Vec(8, 2, 0), Vec(0, 2, 0)})
        corners.emplace_back(at + Turn(angle).back(corner));
    return area(corners);
}
CurveSet end_of(const Region& bar) { return line({bar.loops[0].points[3], bar.loops[0].points[0]}); }

TEST(TurnedLattice, is_along_the_straight_sides_of_an_area) {
    for (const double angle : {0.3, -0.7, pi / 4}) {
        EXPECT_NEAR(std::abs(direction_of(turned_bar(Vec(5, 3, 0), angle), 1)), std::abs(angle), 1e-9);
        const Region bar = turned_bar(Vec(5, 6, 0), angle);
        const CurveSet end = end_of(bar);
        for (const CurveSet* anchor : {static_cast<const CurveSet*>(nullptr), &end}) {
            const auto [turn, boxes, text] = lattice_in_plane(space(true), Vec(1, 1, 0), bar, anchor);
            for (const Vec& corner : bar.loops[0].points) {
                const Vec along = turn.of(corner);
                EXPECT_LT((turn.back(along) - corner).norm(), 1e-12);
                EXPECT_LT(off_nodes(boxes, 0, along[0]) + off_nodes(boxes, 1, along[1]), 1e-9);
            }
            EXPECT_THAT(text, HasSubstr("turned by"));
        }
    }
    EXPECT_EQ(direction_of(turned_bar(Vec(5, 3, 0), 0), 1), 0);
    EXPECT_EQ(direction_of(turned_bar(Vec(5, 3, 0), pi / 2), 1), 0);
    // A triangle has no two sides of one direction, and what is across the longest is too short.
    EXPECT_EQ(direction_of(area({{0, 0, 0}, {6, 2, 0}, {1, 5, 0}}), 1), 0);
}

TEST(TurnedLattice, is_not_turned_where_nodes_stand_on_the_anchor_or_on_a_side_of_the_scene_only_then) {
    const Region bar = turned_bar(Vec(5, 6, 0), 0.3);
    // Cut off by a wall along y.
    std::vector<Vec> corners = bar.loops[0].points;
    corners[0] += (6 - corners[0][0]) / std::cos(0.3) * Vec(std::cos(0.3), std::sin(0.3), 0);
    corners[3] += (6 - corners[3][0]) / std::cos(0.3) * Vec(std::cos(0.3), std::sin(0.3), 0);
    const Region cut = area(corners);
    const CurveSet wall = end_of(cut);
    const LatticeInPlane by_wall = lattice_in_plane(space(), Vec(1, 1, 0), cut, &wall);
    EXPECT_TRUE(by_wall.turn.is_none());
    EXPECT_LT(off_nodes(by_wall.boxes, 0, 6), 1e-9);
    EXPECT_FALSE(lattice_in_plane(space(), Vec(1, 1, 0), cut, nullptr).turn.is_none());
    const Region through = turned_bar(Vec(-1, 4, 0), 0.3);
    EXPECT_TRUE(lattice_in_plane(space(true), Vec(1, 1, 0), through, nullptr).turn.is_none());
    EXPECT_TRUE(lattice_in_plane(space(false, true), Vec(1, 1, 0), through, nullptr).turn.is_none());
    EXPECT_FALSE(lattice_in_plane(space(), Vec(1, 1, 0), through, nullptr).turn.is_none());
}

/// A block in a periodic box of liquid of three metres a side, with 0.25 m between particles.
Texts block_in_liquid(const Vec& low) {
    std::ostringstream geo;
    geo << "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 3, 3, 3};\nBox(2) = {" << low[0] << ", " << low[1] << ", "
        << low[2]
        << ", 2, 1, 1};\nBooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; };\n"
           "Physical Volume(\"water\") = {3};\nPhysical Volume(\"block\") = {2};\n"
           "foot() = Surface In BoundingBox {-1, -1, -1, "
        << low[0] << " + 0.01, 4, 4};\nfoot() -= {Surface In BoundingBox {-1, -1, -1, 0.01, 4, 4}};\n"
        << "Physical Surface(\"foot\") = {foot()};\n";
    return {R"(schema = 1
dimension = 3
[geometry]
file = "channel.geo"
[particles]
spacing = "0.25 m"
[[part]]
name = "water"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 Pa*s"
[[part]]
name = "block"
kind = "elastic"
model = "cells"
density = "1100 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
anchor = "foot"
[flow]
periodic = ["x", "y", "z"]
largest_speed = "0.1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
fields = []
)",
            geo.str()};
}

TEST(OwnLattice, in_space_leaves_the_liquid_its_volume_and_clamps_the_nodes_on_the_anchor) {
    for (const Vec& low : {Vec(0.5, 1, 1), Vec(0.53, 1.08, 1.1), Vec(0.625, 1.125, 1.125)}) {
        const ParticleSet set = mesh_texts(block_in_liquid(low)).particles;
        double all = 0, nearest = 1;
        for (std::size_t i = 0; i < set.size(); ++i) {
            all += set.volume[i];
            if (set.kind(i) != PartKind::fluid) continue;
            for (std::size_t j = 0; j < set.size(); ++j)
                if (set.kind(j) == PartKind::elastic)
                    nearest = std::min(nearest, (set.position[i] - set.position[j]).norm() / 0.25);
        }
        EXPECT_NEAR(all / 27, 1, 1e-9) << low.transpose();
        EXPECT_GE(nearest, 0.9) << low.transpose();
        EXPECT_EQ(set.cells.size(), 8U * 4 * 4);
        std::vector<double> clamped;
        for (const CellNode& node : set.cell_nodes)
            if (node.fixed) clamped.push_back(std::round(1e6 * (node.position[0] - low[0])));
        EXPECT_EQ(clamped.size(), 25U) << low.transpose();
        EXPECT_THAT(clamped, Each(Eq(0)));
    }
}

TEST(OwnLattice, of_a_pipe_clamped_at_one_end_has_nodes_on_its_rim) {
    // Its end is a ring: what is clamped has an inner and an outer rim, both at z = 0.3 m.
    const int around = 40;
    TriangleSurface pipe, end;
    for (const double z : {0.3, 5.3})
        for (const double radius : {1.0, 2.0})
            for (int n = 0; n < around; ++n)
                pipe.corners.emplace_back(radius * std::cos(2 * pi * n / around),
                                          radius * std::sin(2 * pi * n / around), z);
    const auto add = [&](TriangleSurface& to, int a, int b) {
        for (int n = 0; n < around; ++n) {
            const int m = (n + 1) % around;
            to.triangles.push_back({a * around + n, a * around + m, b * around + m});
            to.triangles.push_back({a * around + n, b * around + m, b * around + n});
        }
    };
    end.corners = pipe.corners;
    add(end, 0, 1);
    add(pipe, 0, 1);
    add(pipe, 3, 2);
    add(pipe, 1, 3);
    add(pipe, 2, 0);
    const LatticeMarks marks = marks_of(pipe, &end, 0.5);
    ASSERT_TRUE(marks.anchor[2].has_value());
    EXPECT_NEAR(*marks.anchor[2], 0.3, 1e-12);
    EXPECT_FALSE(marks.anchor[0].has_value() || marks.anchor[1].has_value());
    EXPECT_TRUE(marks.flat[2][0] && marks.flat[2][1]);
    EXPECT_FALSE(marks.flat[0][0] || marks.flat[1][1]);
}

}  // namespace
}  // namespace dmp::tests::own_lattice_tests
