// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Rigid bodies that touch each other, or stand flush on the wall: what of their surfaces fluid sees.
#include <cmath>

#include <gmock/gmock.h>
#include <omp.h>

#include "meshed_text.hpp"
#include "mesher/facing_part.hpp"
#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::touching_bodies_tests {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// A duct of 4 m x 2 m x 2 m, closed all around, and two boxes in it, one upon the other, the lower one on the floor.
const Texts boxes{R"(schema = 1
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
name = "lower"
kind = "rigid"
[[part]]
name = "upper"
kind = "rigid"
[flow]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
                  R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 2, 2};
Box(2) = {1.5, 0, 0.5, 1, 0.5, 1};
Box(3) = {1.5, 0.5, 0.5, 1, 0.25, 1};
Physical Volume("water") = {1};
Physical Surface("wall") = {1, 2, 3, 4, 5, 6};
Physical Volume("lower") = {2};
Physical Volume("upper") = {3};
)"};

/// A wide tube along x, periodic, and a ring segment of a strut whose outer face lies on the tube's wall.
const Texts strut{R"(schema = 1
dimension = 3
[geometry]
file = "channel.geo"
[particles]
spacing = "0.1 m"
[[part]]
name = "water"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 mPa*s"
[[part]]
name = "wall"
kind = "rigid"
[[part]]
name = "strut"
kind = "rigid"
[flow]
periodic = ["x"]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
                  R"(SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 1.25, 0, 0, 1};
Cylinder(2) = {0.5, 0, 0, 0.25, 0, 0, 1};
Cylinder(3) = {0.5, 0, 0, 0.25, 0, 0, 0.8};
BooleanDifference(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };
Physical Volume("water") = {1};
Physical Surface("wall") = {1};
Physical Volume("strut") = {4};
)"};

/// Wall particles whose normal does not lead from them, over their distance and a fifth of a spacing more, to within a
/// twentieth of fluid.
template <class Fluid>
std::size_t astray(const Meshed& meshed, const Fluid& is_fluid) {
    const ParticleSet& set = meshed.particles;
    std::size_t count = 0, walls = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::rigid) continue;
        ++walls;
        Vec position = set.position[i] + (set.wall_distance[i] + 0.2 * set.spacing) * set.wall_normal[i];
        const double period = set.box.extent().x();
        if (set.periodic[0]) position.x() -= period * std::floor((position.x() - set.box.low.x()) / period);
        bool leads_to_fluid = is_fluid(position);
        for (int axis = 0; axis < 3; ++axis)
            for (const double aside : {-0.05, 0.05})
                leads_to_fluid = leads_to_fluid || is_fluid(position + aside * set.spacing * Vec::Unit(axis));
        count += leads_to_fluid ? 0 : 1;
    }
    EXPECT_GT(walls, 1000U);
    return count;
}

bool is_within(const Vec& position, const Vec& low, const Vec& high) {
    return (position.array() > low.array()).all() && (position.array() < high.array()).all();
}

/// In the duct, out of two boxes.
auto out_of(const Vec& low, const Vec& high, const Vec& other_low, const Vec& other_high) {
    return [=](const Vec& position) {
        return is_within(position, Vec::Zero(), Vec(4, 2, 2)) && !is_within(position, low, high) &&
               !is_within(position, other_low, other_high);
    };
}

std::size_t count_of(const Meshed& meshed, const std::string& part) {
    return std::ranges::find(meshed.report.parts, part, &MeshReport::PartLine::name)->particles;
}

TEST(TouchingBodies, look_for_the_fluid_past_each_other) {
    const Meshed meshed = mesh_texts(boxes);
    EXPECT_EQ(astray(meshed, out_of({1.5, 0, 0.5}, {2.5, 0.5, 1.5}, {1.5, 0.5, 0.5}, {2.5, 0.75, 1.5})), 0U);
    // 8 x 2 x 8 points of the upper box, all within three layers of its top or sides.
    EXPECT_EQ(count_of(meshed, "upper"), 128U);
    // 8 x 4 x 8 of the lower one, less the 2 x 3 x 2 that are further from its sides and from the upper one's top.
    EXPECT_EQ(count_of(meshed, "lower"), 256U - 12U);
    EXPECT_THAT(meshed.report.notes,
                Contains(HasSubstr("lower: 50 % of its surface faces no fluid, as it touches other rigid parts")));
    EXPECT_THAT(meshed.report.notes, Contains(HasSubstr("upper: 33.3 % of its surface faces no fluid")));
}

TEST(TouchingBodies, behind_a_thin_one_the_wall_goes_on) {
    const Meshed meshed =
        mesh_texts(boxes.with("Box(2) = {1.5, 0, 0.5, 1, 0.5, 1}", "Box(2) = {1, 0, 0.5, 2, 0.125, 1}")
                       .with("Box(3) = {1.5, 0.5, 0.5, 1, 0.25, 1}", "Box(3) = {3, 1, 1, 1, 1, 1}"));
    EXPECT_EQ(astray(meshed, out_of({1, 0, 0.5}, {3, 0.125, 1.5}, {3, 1, 1}, {4, 2, 2})), 0U);
    const ParticleSet& set = meshed.particles;
    // A layer of the body, then two of the wall, counted from the body's top.
    std::vector<double> depths;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (std::abs(set.position[i].x() - 2) < 0.1 && std::abs(set.position[i].z() - 1) < 0.1 &&
            set.position[i].y() < 0.125 && set.position[i].x() > 2 && set.position[i].z() > 1)
            depths.push_back(set.wall_distance[i] / 0.125);
    EXPECT_THAT(depths,
                ::testing::UnorderedElementsAre(::testing::DoubleNear(0.5, 1e-9), ::testing::DoubleNear(1.5, 1e-9),
                                                ::testing::DoubleNear(2.5, 1e-9)));
}

TEST(TouchingBodies, a_strut_flush_on_a_tube_and_what_is_relaxed) {
    const auto is_fluid = [](const Vec& position) {
        const double radius = std::hypot(position.y(), position.z());
        return radius < 1 && (position.x() < 0.5 || position.x() > 0.75 || radius < 0.8);
    };
    EXPECT_EQ(astray(mesh_texts(strut), is_fluid), 0U);
    const Texts relaxed = strut.with("[[part]]", "fill = \"relaxed\"\n[[part]]").with("0.1 m", "0.125 m");
    EXPECT_EQ(astray(mesh_texts(relaxed), is_fluid), 0U);
}

TEST(TouchingBodies, that_touch_nothing_are_as_they_were) {
    const Meshed meshed = mesh_texts(boxes.with("Box(2) = {1.5, 0, 0.5", "Box(2) = {0.5, 0.75, 0.5")
                                         .with("Box(3) = {1.5, 0.5, 0.5", "Box(3) = {2, 1, 0.5"));
    EXPECT_EQ(astray(meshed, out_of({0.5, 0.75, 0.5}, {1.5, 1.25, 1.5}, {2, 1, 0.5}, {3, 1.25, 1.5})), 0U);
    for (const std::string& note : meshed.report.notes) EXPECT_THAT(note, ::testing::Not(HasSubstr("faces no fluid")));
}

TEST(TouchingBodies, that_move_may_come_apart) {
    const Meshed meshed = mesh_texts(boxes.with("name = \"upper\"\nkind = \"rigid\"",
                                                "name = \"upper\"\nkind = \"rigid\"\nvelocity = [0, \"1 m/s\", 0]"));
    for (const std::string& note : meshed.report.notes) EXPECT_THAT(note, ::testing::Not(HasSubstr("faces no fluid")));
}

TEST(FacingPart, is_cut_where_it_begins) {
    TriangleSurface square;
    square.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto part = [&](const auto& counts) { return facing_part(square, 0.05, counts); };
    EXPECT_EQ(part([](const Vec&, const Vec&) { return true; }).triangles.size(), 2U);  // whole ones stay whole
    EXPECT_TRUE(part([](const Vec&, const Vec&) { return false; }).triangles.empty());
    const TriangleSurface disc = part([](const Vec& position, const Vec& normal) {
        EXPECT_EQ(normal, Vec(0, 0, 1));
        return (position - Vec(0.5, 0.5, 0)).norm() < 0.4;
    });
    EXPECT_NEAR(disc.area(), 0.16 * 3.14159265, 0.02);
    for (const Vec& corner : disc.corners) EXPECT_LT((corner - Vec(0.5, 0.5, 0)).norm(), 0.401);
}

TEST(FacingPart, is_the_same_by_any_number_of_threads) {
    const TriangleSurface surface = ball(16);
    const auto part = [&](int threads) {
        const int before = omp_get_max_threads();
        omp_set_num_threads(threads);
        const TriangleSurface cap = facing_part(
            surface, 0.05, [](const Vec& position, const Vec&) { return position.x() + position.y() < 0.3; });
        omp_set_num_threads(before);
        return cap;
    };
    const TriangleSurface one = part(1), three = part(3);
    EXPECT_GT(one.triangles.size(), 1000U);
    EXPECT_LT(one.area(), 0.9 * surface.area());
    EXPECT_EQ(one.triangles, three.triangles);
    EXPECT_EQ(one.corners, three.corners);
}

}  // namespace
}  // namespace dmp::tests::touching_bodies_tests
