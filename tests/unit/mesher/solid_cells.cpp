// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/solid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "mesher/bonded_solids.hpp"
#include "mesher/cell_solids.hpp"
#include "mesher/region_on_boxes.hpp"
#include "mesher/solid_on_boxes.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::solid_cells_tests {
namespace {

constexpr double pi = std::numbers::pi;

Polyline loop_of(const std::vector<Vec>& points) { return {points, true}; }

/// A rectangle about a point, turned by an angle [rad].
Polyline rectangle(const Vec& middle, double length, double height, double angle = 0) {
    std::vector<Vec> points;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        const double along = x * length / 2, across = y * height / 2;
        points.push_back(middle + Vec(std::cos(angle) * along - std::sin(angle) * across,
                                      std::sin(angle) * along + std::cos(angle) * across, 0));
    }
    return loop_of(points);
}

Polyline disc(const Vec& middle, double radius, int points, bool hole = false) {
    Polyline circle{{}, true};
    for (int n = 0; n < points; ++n) {
        const double angle = (hole ? -2 : 2) * pi * n / points;
        circle.points.push_back(middle + radius * Vec(std::cos(angle), std::sin(angle), 0));
    }
    return circle;
}

BoxLattice square_boxes(double step) { return {2, Vec(-7, -3, 0), Vec(step, step, 0)}; }

/// All of them as one.
Filling all_of(const SolidCells& cells) {
    Filling sum = cells.fillings.front();
    for (std::size_t n = 1; n < cells.fillings.size(); ++n) sum.add(cells.fillings[n]);
    return sum;
}

/// That each corner's node is where the box has it.
void expect_nodes_on_corners(const SolidCells& cells, int dimension) {
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        const SolidCell& cell = cells.cells[n];
        const Vec middle = cells.fillings[n].centroid - cell.centroid;
        for (int k = 0; k < 1 << dimension; ++k) {
            Vec corner = middle;
            for (int axis = 0; axis < dimension; ++axis) corner[axis] += (k >> axis & 1 ? 0.5 : -0.5) * cell.size[axis];
            EXPECT_LT((cells.nodes[cell.node[k]].position - corner).norm(), 1e-12);
        }
    }
}

TEST(Filling, adds_up_to_the_moments_of_both) {
    // Two halves of a box of 2 x 1.
    Filling left{1, Vec(-0.5, 0, 0), Vec(1.0 / 12, 1.0 / 12, 0)};
    left.add({1, Vec(0.5, 0, 0), Vec(1.0 / 12, 1.0 / 12, 0)});
    EXPECT_EQ(left.volume, 2);
    EXPECT_LT(left.centroid.norm(), 1e-15);
    EXPECT_NEAR(left.moment[0], 4.0 / 12, 1e-15);
    EXPECT_NEAR(left.moment[1], 1.0 / 12, 1e-15);
}

TEST(PlaneCells, of_an_area_along_the_lattice_are_whole) {
    const Region region{"beam", {rectangle(Vec(0, 0, 0), 4, 1)}};
    const BoxLattice boxes{2, Vec(-2, -0.5, 0), Vec(0.25, 0.25, 0)};
    const SolidCells cells = RegionOnBoxes(region, boxes).cells();
    EXPECT_EQ(cells.cells.size(), 64U);
    EXPECT_EQ(cells.nodes.size(), 17U * 5U);
    EXPECT_EQ(cells.cut, 0U);
    EXPECT_EQ(cells.merged, 0U);
    EXPECT_EQ(cells.pieces, 1);
    expect_nodes_on_corners(cells, 2);
    for (const Filling& filling : cells.fillings) {
        EXPECT_NEAR(filling.volume, 0.0625, 1e-15);
        EXPECT_NEAR(filling.moment[0], 0.0625 / 12, 1e-15);
    }
}

TEST(PlaneCells, keep_the_moments_of_what_is_drawn_however_it_lies) {
    for (const double angle : {0.0, 0.35, pi / 4, 1.2})
        for (const double shift : {0.0, 0.13, 0.4}) {
            const Vec middle(shift, 0.3 * shift, 0);
            const Region region{"beam", {rectangle(middle, 6, 1, angle)}};
            const SolidCells cells = RegionOnBoxes(region, square_boxes(0.25)).cells();
            EXPECT_EQ(cells.lost, 0U);
            EXPECT_EQ(cells.pieces, 1);
            const Filling all = all_of(cells);
            EXPECT_NEAR(all.volume, 6, 1e-11);
            EXPECT_LT((all.centroid - middle).norm(), 2e-3);  // where a particle had to stay in its box
            const double cosine = std::cos(angle), sine = std::sin(angle);
            EXPECT_NEAR(all.moment[0], (36 * cosine * cosine + sine * sine) / 12, 3e-3);
            EXPECT_NEAR(all.moment[1], (36 * sine * sine + cosine * cosine) / 12, 3e-3);
            expect_nodes_on_corners(cells, 2);
        }
}

TEST(PlaneCells, of_a_ring_have_its_volume_and_a_hole) {
    const Region region{"ring", {disc(Vec::Zero(), 2.5, 400), disc(Vec::Zero(), 1.5, 400, true)}};
    const SolidCells cells = RegionOnBoxes(region, square_boxes(0.23)).cells();
    EXPECT_NEAR(cells.volume() + cells.lost_volume, region.area(), 1e-11);
    EXPECT_EQ(cells.lost, 0U);
    EXPECT_EQ(cells.pieces, 1);
    const Filling all = all_of(cells);
    EXPECT_NEAR(all.moment[0], (2.5 * 2.5 + 1.5 * 1.5) / 4, 5e-3);
}

TEST(PlaneCells, with_little_solid_go_to_a_neighbour) {
    // A box and a fifth of the next one.
    const Region region{"strip", {rectangle(Vec(0.6, 0.5, 0), 1.2, 1)}};
    const BoxLattice boxes{2, Vec(0, 0, 0), Vec(1, 1, 0)};
    const SolidCells cells = RegionOnBoxes(region, boxes).cells();
    ASSERT_EQ(cells.cells.size(), 1U);
    EXPECT_EQ(cells.merged, 1U);
    EXPECT_NEAR(cells.fillings[0].volume, 1.2, 1e-14);
    EXPECT_NEAR(cells.fillings[0].centroid[0], 0.6, 1e-14);
    EXPECT_NEAR(cells.fillings[0].moment[0], 1.2 * 1.2 / 12, 1e-14);
    EXPECT_NEAR(cells.cells[0].centroid[0], 0.1, 1e-14);
}

TEST(PlaneCells, on_both_sides_of_a_slit_between_boxes_share_no_nodes) {
    // Two strips that touch along the line y = 0 between rows of boxes, but are drawn as one area by a bridge at x > 3.
    const Region region{"fork",
                        {loop_of({Vec(0, -1, 0), Vec(4, -1, 0), Vec(4, 1, 0), Vec(0, 1, 0), Vec(0, 1e-3, 0),
                                  Vec(3, 1e-3, 0), Vec(3, -1e-3, 0), Vec(0, -1e-3, 0)})}};
    const BoxLattice boxes{2, Vec(0, -1, 0), Vec(0.5, 0.5, 0)};
    const SolidCells cells = RegionOnBoxes(region, boxes).cells();
    EXPECT_EQ(cells.cells.size(), 32U);
    EXPECT_EQ(cells.pieces, 1);
    // 9 x 5 nodes, and those of the slit from x = 0 to before its end at x = 3 twice.
    EXPECT_EQ(cells.nodes.size(), 45U + 6U);
}

TEST(PlaneCells, of_two_areas_that_meet_at_a_corner_are_two_pieces) {
    const Region region{"two", {rectangle(Vec(0.5, 0.5, 0), 1, 1), rectangle(Vec(1.5, 1.5, 0), 1, 1)}};
    const SolidCells cells = RegionOnBoxes(region, BoxLattice{2, Vec(0, 0, 0), Vec(0.5, 0.5, 0)}).cells();
    EXPECT_EQ(cells.pieces, 2);
    EXPECT_EQ(cells.cells.size(), 8U);
    EXPECT_EQ(cells.nodes.size(), 18U);
    EXPECT_EQ(std::set<int>(cells.piece.begin(), cells.piece.end()), (std::set<int>{0, 1}));
}

/// A box lattice with four boxes along x in a period.
BoxLattice boxes_in_a_period(int dimension) {
    return {dimension, Vec(0, -0.5, 0), Vec(0.25, 0.25, dimension == 3 ? 0.25 : 0), {4, 0, 0}};
}

void expect_corners_with_periods(const SolidCells& cells, int dimension) {
    const Box box{Vec(0, -0.5, 0), Vec(1, 0.5, 1)};
    std::size_t beyond = 0;
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        const SolidCell& cell = cells.cells[n];
        const Vec middle = cells.fillings[n].centroid - cell.centroid;
        for (int k = 0; k < 1 << dimension; ++k) {
            Vec corner = middle;
            for (int axis = 0; axis < dimension; ++axis) corner[axis] += (k >> axis & 1 ? 0.5 : -0.5) * cell.size[axis];
            EXPECT_LT((cells.nodes[cell.node[k]].position + cell.shift(k, box) - corner).norm(), 1e-12);
            if (cell.shift(k, box)[0] > 0) ++beyond;
        }
    }
    EXPECT_GT(beyond, 0U);
}

TEST(PlaneCells, go_on_through_a_periodic_side) {
    const Region through{"strip", {rectangle(Vec(0.5, 0, 0), 1, 0.5)}};
    const BoxLattice boxes = boxes_in_a_period(2);
    const SolidCells cells = RegionOnBoxes(through, boxes).cells();
    EXPECT_EQ(cells.cells.size(), 8U);
    EXPECT_EQ(cells.nodes.size(), 12U);
    EXPECT_EQ(cells.pieces, 1);
    expect_corners_with_periods(cells, 2);
    // One that ends at one of the sides does not.
    const Region short_of_it{"strip", {rectangle(Vec(0.55, 0, 0), 0.9, 0.5)}};
    const SolidCells ends = RegionOnBoxes(short_of_it, boxes).cells();
    for (const SolidCell& cell : ends.cells)
        EXPECT_EQ(cell.periods & ~SolidCell::period_bit(1, 0) & ~SolidCell::period_bit(3, 0), 0);
    EXPECT_GT(ends.nodes.size(), 3 * ends.cells.size() / 2);
}

TEST(PlaneCells, say_what_is_too_thin) {
    Part part;
    part.name = std::string("film");
    const Region region{"film", {rectangle(Vec(0, 0.1, 0), 4, 0.1)}};
    const SolidCells cells = RegionOnBoxes(region, BoxLattice{2, Vec(-7, -3, 0), Vec(1, 1, 0)}).cells();
    EXPECT_TRUE(cells.cells.empty());
    EXPECT_NEAR(cells.lost_volume, 0.4, 1e-12);
    EXPECT_THROW(check_filled(part, cells, 0.4), InputError);
}

/// A box of triangles that face outward.
TriangleSurface box_surface(const Vec& low, const Vec& high) {
    TriangleSurface surface;
    for (int k = 0; k < 8; ++k)
        surface.corners.emplace_back(k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]);
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        surface.triangles.push_back({a, b, c});
        surface.triangles.push_back({a, c, d});
    }
    return surface;
}

TEST(SpaceCells, of_a_box_along_the_lattice_are_whole) {
    const TriangleSurface surface = box_surface(Vec(0, 0, 0), Vec(2, 1, 0.5));
    const SolidCells cells = SolidOnBoxes(surface, {3, Vec(-1, -1, -1), Vec(0.25, 0.25, 0.25)}).cells();
    EXPECT_EQ(cells.cells.size(), 8U * 4 * 2);
    EXPECT_EQ(cells.nodes.size(), 9U * 5 * 3);
    EXPECT_EQ(cells.cut, 0U);
    EXPECT_EQ(cells.pieces, 1);
    expect_nodes_on_corners(cells, 3);
    for (const Filling& filling : cells.fillings) {
        EXPECT_NEAR(filling.volume, 1.0 / 64, 1e-15);
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(filling.moment[axis], 0.0625 / 12, 1e-14);
    }
}

TEST(SpaceCells, of_a_box_that_cuts_the_lattice_have_its_volume_and_moments) {
    const Vec low(0.11, -0.32, 0.05), high(2.03, 0.71, 0.62);
    const SolidCells cells = SolidOnBoxes(box_surface(low, high), {3, Vec(-1, -1, -1), Vec(0.25, 0.2, 0.25)}).cells();
    const Filling all = all_of(cells);
    const Vec extent = high - low;
    EXPECT_EQ(cells.lost, 0U);
    EXPECT_GT(cells.cut, 0U);
    EXPECT_NEAR(all.volume / extent.prod(), 1, 0.06);  // lines stand for a seventh of a box
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(all.moment[axis] * 12 / (extent[axis] * extent[axis]), 1, 0.1);
    EXPECT_EQ(cells.pieces, 1);
    expect_nodes_on_corners(cells, 3);
}

TEST(SpaceCells, of_two_boxes_are_two_pieces_where_lines_see_the_gap) {
    // They touch on a plane of the lattice, with a gap of a thousandth of a box.
    TriangleSurface surface = box_surface(Vec(0, 0, 0), Vec(1, 1, 0.9995));
    const TriangleSurface above = box_surface(Vec(0, 0, 1.0005), Vec(1, 1, 2));
    const int first = static_cast<int>(surface.corners.size());
    surface.corners.insert(surface.corners.end(), above.corners.begin(), above.corners.end());
    for (auto triangle : above.triangles) {
        for (int& corner : triangle) corner += first;
        surface.triangles.push_back(triangle);
    }
    // The lattice's lines do not see the gap: it is thinner than they are apart.
    const SolidCells seen = SolidOnBoxes(surface, {3, Vec::Zero(), Vec::Constant(0.5)}).cells();
    EXPECT_EQ(seen.cells.size(), 16U);
    EXPECT_EQ(seen.pieces, 1);
    // Moved apart by more than that, they are two.
    for (int k = 4; k < 8; ++k) surface.corners[static_cast<std::size_t>(k)][2] = 0.9;
    const SolidCells apart = SolidOnBoxes(surface, {3, Vec::Zero(), Vec::Constant(0.5)}).cells();
    EXPECT_EQ(apart.pieces, 2);
    EXPECT_EQ(apart.nodes.size(), 2U * 27);
}

TEST(SpaceCells, go_on_through_a_periodic_side) {
    const SolidCells cells =
        SolidOnBoxes(box_surface(Vec(0, -0.25, 0.25), Vec(1, 0.25, 0.5)), boxes_in_a_period(3)).cells();
    EXPECT_EQ(cells.cells.size(), 8U);
    EXPECT_EQ(cells.nodes.size(), 4U * 3 * 2);
    EXPECT_EQ(cells.pieces, 1);
    expect_corners_with_periods(cells, 3);
}

TEST(Anchors, clamp_the_nearest_row_of_nodes_and_those_outside_the_solid_beside_their_edge) {
    const Vec normal(1, 0, 0);
    for (const bool of_cut : {false, true}) {
        EXPECT_TRUE(is_clamped(Vec(0, 0, 0), normal, 1, of_cut));
        EXPECT_TRUE(is_clamped(Vec(0.5, 0, 0), normal, 1, of_cut));
        EXPECT_TRUE(is_clamped(Vec(-0.4, 0, 0), normal, 1, of_cut));
        EXPECT_FALSE(is_clamped(Vec(0.6, 0, 0), normal, 1, of_cut));
        EXPECT_FALSE(is_clamped(Vec(0, 1.1, 0), normal, 1, of_cut));
        EXPECT_FALSE(is_clamped(Vec(1, 0.8, 0), normal, 1, of_cut));
        EXPECT_EQ(is_clamped(Vec(0, 0.8, 0.1), normal, 1, of_cut), of_cut);
    }
}

TEST(Anchors, at_a_point_clamp_the_cell_there) {
    const Region region{"beam", {rectangle(Vec(2, 0.5, 0), 4, 1)}};
    SolidCells cells = RegionOnBoxes(region, BoxLattice{2, Vec(0, 0, 0), Vec(0.5, 0.5, 0)}).cells();
    clamp_cell_at(Vec(0.1, 0.1, 0), 2, 0.5, cells);
    EXPECT_EQ(std::ranges::count(cells.nodes, true, &CellNode::fixed), 4);
    for (const CellNode& node : cells.nodes) EXPECT_EQ(node.fixed, node.position[0] < 0.6 && node.position[1] < 0.6);
    SolidCells far = RegionOnBoxes(region, BoxLattice{2, Vec(0, 0, 0), Vec(0.5, 0.5, 0)}).cells();
    clamp_cell_at(Vec(-3, 0, 0), 2, 0.5, far);
    EXPECT_EQ(std::ranges::count(far.nodes, true, &CellNode::fixed), 0);
}

/// A space of 4 x 2 with these sides.
ParticleSpace space_with(bool periodic, bool mirrored) {
    ParticleSpace space;
    space.spacing = 0.5;
    space.box = {Vec(0, 0, 0), Vec(4, 2, 0)};
    space.periodic[0] = periodic;
    space.mirrored[0] = {mirrored, mirrored};
    return space;
}

TEST(PlaneCells, end_where_the_scene_does) {
    const Region region{"disc", {disc(Vec(0, 1, 0), 0.9, 100)}};
    for (const bool periodic : {true, false}) {
        const BoxLattice boxes = boxes_of(space_with(periodic, !periodic), Vec(0.5, 0.5, 0));
        const SolidCells cells = RegionOnBoxes(region, boxes).cells();
        EXPECT_NEAR(cells.volume() / region.area(), 0.5, 1e-6);
        for (const CellNode& node : cells.nodes) EXPECT_GE(node.position[0], 0);
    }
}

TEST(PlaneCells, stay_on_a_plane_of_symmetry_that_they_reach) {
    const ParticleSpace space = space_with(false, true);
    const BoxLattice boxes = boxes_of(space, Vec(0.5, 0.5, 0));
    for (const double gap : {0.0, 0.15}) {
        const Region region{"beam", {rectangle(Vec(1 + gap / 2, 1, 0), 2 - gap, 1)}};
        SolidCells cells = RegionOnBoxes(region, boxes).cells();
        hold_on_planes(space, cells);
        const auto held = std::ranges::count_if(cells.nodes, [](const CellNode& node) { return node.on_plane[0]; });
        EXPECT_EQ(held, gap == 0 ? 3 : 0);
    }
}

/// An area with these corners in a box of 6 m x 6 m of liquid that goes on across both axes.
Texts in_liquid(const std::vector<Vec>& corners, const std::string& spacing) {
    std::ostringstream geo;
    geo.precision(17);
    geo << "Point(1) = {0, 0, 0};\nPoint(2) = {6, 0, 0};\nPoint(3) = {6, 6, 0};\nPoint(4) = {0, 6, 0};\n"
           "Line(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\nCurve Loop(1) = {1, 2, 3, "
           "4};\n";
    for (std::size_t n = 0; n < corners.size(); ++n)
        geo << "Point(" << 10 + n << ") = {" << corners[n][0] << ", " << corners[n][1] << ", 0};\n";
    for (std::size_t n = 0; n < corners.size(); ++n)
        geo << "Line(" << 1000 + n << ") = {" << 10 + n << ", " << 10 + (n + 1) % corners.size() << "};\n";
    geo << "Curve Loop(2) = {1000:" << 999 + corners.size()
        << "};\nPlane Surface(1) = {1, 2};\nPlane Surface(2) = {2};\n"
        << "Physical Surface(\"water\") = {1};\nPhysical Surface(\"solid\") = {2};\n";
    return {"schema = 1\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = \"" + spacing +
                "\"\n[[part]]\nname = \"water\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 Pa*s\"\n"
                "[[part]]\nname = \"solid\"\nkind = \"elastic\"\nmodel = \"cells\"\ndensity = \"1100 kg/m^3\"\n"
                "youngs_modulus = \"1 MPa\"\npoisson_ratio = 0.3\n[flow]\nperiodic = [\"x\", \"y\"]\nlargest_speed = "
                "\"0.1 m/s\"\n[run]\nduration = \"1 s\"\n[output]\nevery = \"1 s\"\nfields = []\n",
            geo.str()};
}

TEST(LiquidBesideCells, fills_the_rest_of_the_boxes_that_they_cut) {
    for (const Vec& shift : {Vec(0.03, 0.08, 0), Vec(0, 0, 0), Vec(0.1, 0.05, 0)})
        for (const bool is_disc : {true, false}) {
            const Vec along(std::cos(std::numbers::pi / 9), std::sin(std::numbers::pi / 9), 0),
                up(-along[1], along[0], 0);
            const Vec middle = Vec(3, 3, 0) + shift;
            std::vector<Vec> corners;
            for (int n = 0; is_disc && n < 60; ++n) {
                const double angle = std::numbers::pi * n / 30;
                corners.emplace_back(middle + 0.5 * Vec(std::cos(angle), std::sin(angle), 0));
            }
            if (!is_disc)
                for (const auto& [x, y] : {std::pair{-2.0, -0.5}, {2.0, -0.5}, {2.0, 0.5}, {-2.0, 0.5}})
                    corners.emplace_back(middle + x * along + y * up);
            const ParticleSet set = mesh_texts(in_liquid(corners, "0.25 m")).particles;
            double volume = 0, solid = 0, mass = 0, nearest = 1;
            for (std::size_t i = 0; i < set.size(); ++i) {
                volume += set.volume[i];
                if (set.kind(i) != PartKind::fluid) solid += set.volume[i];
                if (set.kind(i) != PartKind::fluid) continue;
                EXPECT_NEAR(set.volume[i], 0.0625, 0.001 * 0.0625);
                mass += set.mass[i];
                for (std::size_t j = 0; j < set.size(); ++j)
                    if (set.kind(j) == PartKind::elastic)
                        nearest = std::min(nearest, (set.position[i] - set.position[j]).norm() / 0.25);
            }
            EXPECT_NEAR(volume / 36, 1, 1e-9) << shift.transpose() << (is_disc ? ", disc" : ", strip");
            EXPECT_NEAR(mass, 1000 * (36 - solid), 1e-5);
            EXPECT_GE(nearest, 0.699);
        }
}

TEST(Bodies, of_cells_hang_together_by_their_nodes) {
    const Region region{"two", {rectangle(Vec(0.5, 0.5, 0), 1, 1), rectangle(Vec(2.5, 0.5, 0), 1, 1)}};
    const SolidCells cells = RegionOnBoxes(region, BoxLattice{2, Vec(0, 0, 0), Vec(0.5, 0.5, 0)}).cells();
    ParticleSet set;
    set.parts = {{"two", PartKind::elastic}};
    for (const Filling& filling : cells.fillings) {
        set.position.push_back(filling.centroid);
        set.part.push_back(0);
        set.body.push_back(-1);
    }
    add_cells_of(cells, 0, set);
    number_bodies(set);
    EXPECT_EQ(set.body, cells.piece);
}

}  // namespace
}  // namespace dmp::tests::solid_cells_tests
