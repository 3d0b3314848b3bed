// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces in 3-D that touch, as triangles.
#include "mesher/contact_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "geometry/surface_edges.hpp"
#include "meshed_text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::contact_triangles_tests {
namespace {

constexpr double spacing = 0.125;

/// A block that floats in a duct of 2 m x 1 m x 1 m along x between walls, periodic along x.
const Texts block{R"(schema = 1
dimension = 3
[geometry]
file = "channel.geo"
[particles]
spacing = "0.125 m"
[[part]]
name = "water"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 mPa*s"
[[part]]
name = "wall"
kind = "rigid"
[[part]]
name = "body"
kind = "elastic"
density = "1200 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.25
[flow]
periodic = ["x"]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
                  R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 2, 1, 1};
Box(2) = {0.75, 0.25, 0.25, 0.5, 0.25, 0.5};
Physical Volume("water") = {1};
Physical Surface("wall") = {3, 4, 5, 6};
Physical Volume("body") = {2};
)"};

/// In its place a flat sheet of 0.5 m x 0.5 m in y = 0.5 m.
const Texts sheet = block.with("poisson_ratio = 0.25", "poisson_ratio = 0.25\nthickness = \"0.05 m\"")
                        .with("Box(2) = {0.75, 0.25, 0.25, 0.5, 0.25, 0.5};",
                              "Point(101) = {0.75, 0.5, 0.25};\nPoint(102) = {1.25, 0.5, 0.25};\n"
                              "Point(103) = {1.25, 0.5, 0.75};\nPoint(104) = {0.75, 0.5, 0.75};\n"
                              "Line(101) = {101, 102};\nLine(102) = {102, 103};\nLine(103) = {103, 104};\n"
                              "Line(104) = {104, 101};\nCurve Loop(101) = {101, 102, 103, 104};\n"
                              "Plane Surface(101) = {101};\n")
                        .with("Physical Volume(\"body\") = {2}", "Physical Surface(\"body\") = {101}");

/// The pieces of a part as a surface, and how thick the solid behind each is.
struct Drawn {
    TriangleSurface surface;
    std::vector<double> thickness;

    [[nodiscard]] Vec corner(std::size_t triangle, std::size_t k) const {
        return surface.corners[static_cast<std::size_t>(surface.triangles[triangle].at(k))];
    }
    [[nodiscard]] Vec normal(std::size_t t) const {
        return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized();
    }
    [[nodiscard]] Vec middle(std::size_t t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3; }
};

Drawn pieces_of(const ParticleSet& set, const std::string& part) {
    Drawn drawn;
    drawn.surface.corners = set.contact_points;
    for (const ContactPiece& piece : set.contact_pieces) {
        if (piece.part != set.part_named(part)) continue;
        drawn.surface.triangles.push_back({piece.a, piece.b, piece.c});
        drawn.thickness.push_back(piece.thickness);
    }
    return drawn;
}

double longest_edge(const Drawn& drawn) {
    double longest = 0;
    for (std::size_t t = 0; t < drawn.thickness.size(); ++t)
        for (const std::size_t k : {0U, 1U, 2U})
            longest = std::max(longest, (drawn.corner(t, k) - drawn.corner(t, (k + 1) % 3)).norm());
    return longest;
}

TEST(ContactTriangles, of_a_block_close_it_and_know_how_thick_it_is) {
    const auto meshed = mesh_texts(block);
    const Drawn body = pieces_of(meshed.particles, "body");
    EXPECT_TRUE(count_edges(body.surface).closed());
    EXPECT_NEAR(body.surface.area(), 2 * (0.5 * 0.25 + 0.25 * 0.5 + 0.5 * 0.5), 1e-12);
    EXPECT_NEAR(body.surface.enclosed_volume(), 0.5 * 0.25 * 0.5, 1e-12) << "they face outward";
    EXPECT_LE(longest_edge(body), (1 + 1e-9) * spacing);
    for (std::size_t t = 0; t < body.thickness.size(); ++t)
        EXPECT_NEAR(body.thickness[t], std::abs(body.normal(t).y()) > 0.9 ? 0.25 : 3 * spacing, 1e-12);
}

TEST(ContactTriangles, of_a_vessel_face_the_liquid_and_go_on_through_periodic_sides) {
    const auto meshed = mesh_texts(block);
    const Drawn wall = pieces_of(meshed.particles, "wall");
    EXPECT_NEAR(wall.surface.area(), 4 * 2.0, 1e-11);
    EXPECT_LE(longest_edge(wall), (1 + 1e-9) * spacing);
    for (std::size_t t = 0; t < wall.thickness.size(); ++t) {
        const Vec to_axis = Vec(0, 0.5, 0.5) - Vec(0, wall.middle(t).y(), wall.middle(t).z());
        EXPECT_GT(wall.normal(t).dot(to_axis), 0.49);
        EXPECT_EQ(wall.thickness[t], 3 * spacing);
    }
    EXPECT_EQ(count_edges(wall.surface).many_fold, 0U);
}

TEST(ContactTriangles, of_a_body_across_a_periodic_side_leave_it_out) {
    const auto meshed = mesh_texts(block.with("Box(2) = {0.75, 0.25, 0.25, 0.5", "Box(2) = {0, 0.25, 0.25, 2"));
    const Drawn body = pieces_of(meshed.particles, "body");
    EXPECT_NEAR(body.surface.area(), 2 * 2 * (0.25 + 0.5), 1e-11);
    for (std::size_t t = 0; t < body.thickness.size(); ++t) EXPECT_LT(std::abs(body.normal(t).x()), 1e-9);
}

TEST(ContactTriangles, of_a_shell_are_both_sides_and_the_rim) {
    const auto meshed = mesh_texts(sheet);
    const Drawn body = pieces_of(meshed.particles, "body");
    ASSERT_FALSE(body.thickness.empty());
    EXPECT_TRUE(count_edges(body.surface).closed());
    EXPECT_NEAR(body.surface.area(), 2 * 0.5 * 0.5 + 4 * 0.5 * 0.05, 1e-12);
    EXPECT_NEAR(body.surface.enclosed_volume(), 0.5 * 0.5 * 0.05, 1e-12);
    EXPECT_LE(longest_edge(body), (1 + 1e-9) * spacing);
    for (const double thickness : body.thickness) EXPECT_EQ(thickness, 0.05);
}

TEST(ContactTriangles, of_a_wall_with_liquid_on_both_sides_are_two_that_share_no_point) {
    // The duct in two halves; the wall between them has a surface of its own.
    const Texts halves =
        block
            .with("Box(1) = {0, 0, 0, 2, 1, 1};", "Box(1) = {0, 0, 0, 2, 0.75, 1};\nBox(3) = {0, 0.75, 0, 2, 0.25, 1};")
            .with("Physical Volume(\"water\") = {1};", "Physical Volume(\"water\") = {1, 3};")
            .with("{3, 4, 5, 6}", "{3, 5, 6, 16, 17, 18}")
            .with("name = \"wall\"\nkind = \"rigid\"",
                  "name = \"wall\"\nkind = \"rigid\"\n[[part]]\nname = \"between\"\nkind = \"rigid\"")
            .with("Physical Volume(\"body\")", "Physical Surface(\"between\") = {4};\nPhysical Volume(\"body\")");
    Folder folder;
    Folder::write(halves.scene);
    Folder::write(halves.cad_geometry, "channel.geo");
    const Scene scene = read_scene("scene.toml");
    const Geometry geometry = read_geometry(geometry_options_of(scene));
    ParticleSet set;
    set.dimension = 3;
    set.spacing = spacing;
    set.box = {Vec::Zero(), Vec(2, 1, 1)};
    set.periodic = {true, false, false};
    for (const PartKind kind : {PartKind::fluid, PartKind::rigid, PartKind::elastic})
        for (const Part* part : scene.parts_of(kind)) set.parts.push_back({*part->name, kind});
    draw_contact_triangles(geometry, scene, {}, set);
    const Drawn between = pieces_of(set, "between");
    EXPECT_NEAR(between.surface.area(), 2 * 2.0, 1e-11);
    std::set<int> above, below;
    for (std::size_t t = 0; t < between.thickness.size(); ++t) {
        EXPECT_EQ(between.thickness[t], 0);
        (between.normal(t).y() > 0 ? above : below)
            .insert(between.surface.triangles[t].begin(), between.surface.triangles[t].end());
    }
    EXPECT_EQ(above.size(), below.size());
    std::vector<int> both;
    std::ranges::set_intersection(above, below, std::back_inserter(both));
    EXPECT_TRUE(both.empty());
}

TEST(ContactTriangles, of_a_rigid_volume_face_the_liquid_around_it) {
    const auto meshed =
        mesh_texts(block
                       .with("name = \"wall\"\nkind = \"rigid\"",
                             "name = \"wall\"\nkind = \"rigid\"\n[[part]]\nname = \"post\"\nkind = \"rigid\"")
                       .with("Physical Volume(\"body\")",
                             "Box(3) = {0.25, 0, 0.25, 0.25, 1, 0.25};\nPhysical Volume(\"post\") = {3};\n"
                             "Physical Volume(\"body\")"));
    const Drawn post = pieces_of(meshed.particles, "post");
    EXPECT_NEAR(post.surface.area(), 4 * 0.25, 1e-12) << "not its ends, on the walls";
    for (std::size_t t = 0; t < post.thickness.size(); ++t) EXPECT_NEAR(post.thickness[t], 0.25, 1e-12);
}

TEST(ContactTriangles, are_not_drawn_where_particles_touch) {
    const auto meshed = mesh_texts(block.with("[flow]", "[contact]\nbetween = \"particles\"\n[flow]"));
    EXPECT_TRUE(meshed.particles.contact_pieces.empty());
}

}  // namespace
}  // namespace dmp::tests::contact_triangles_tests
