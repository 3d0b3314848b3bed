// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of cells from a geometry: what holds them, where they go on, and what ends them.
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_cells_in_scenes_tests {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A beam of 4 m x 0.5 m along x that bends under its weight, clamped at its low end.
const Texts beam{R"(schema = 1
[geometry]
file = "channel.geo"
[particles]
spacing = "0.125 m"
[[part]]
name = "beam"
kind = "elastic"
model = "cells"
density = "1000 kg/m^3"
youngs_modulus = "20 MPa"
poisson_ratio = 0.3
anchor = "clamp"
mass_damping = "20 1/s"
[flow]
acceleration = [0, "-1 m/s^2"]
largest_speed = "1 m/s"
[numerics]
sound_speed = "100 m/s"
[contact]
range = 0
[run]
duration = "1 s"
[output]
every = "1 s"
fields = []
solid_fields = ["displacement"]
)",
                 R"(Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Point(3) = {4, 0.5, 0};
Point(4) = {0, 0.5, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("beam") = {1};
Physical Curve("clamp") = {4};
)"};

class LastFrame : public FrameSink {
  public:
    void write(const Frame& frame) override { last = frame; }
    Frame last;
};

/// Displacements of its particles at the end, by where they were drawn, in hundredths of a metre.
std::map<std::pair<long, long>, double> sag(const Texts& texts) {
    const Meshed meshed = mesh_texts(texts);
    LastFrame sink;
    RunOptions options;
    options.sink = &sink;
    Simulation(meshed.scene, meshed.particles, Resources(1)).run(options);
    std::map<std::pair<long, long>, double> sag;
    const FrameGroup& solid = *std::ranges::find(sink.last.groups, "solid", &FrameGroup::name);
    const FrameField& field = *std::ranges::find(solid.fields, "displacement", &FrameField::name);
    for (std::size_t k = 0; k < solid.id.size(); ++k) {
        const Vec& drawn = meshed.particles.position[static_cast<std::size_t>(solid.id[k])];
        sag[{std::lround(100 * drawn[0]), std::lround(100 * drawn[1])}] = static_cast<double>(field.values[3 * k + 1]);
    }
    return sag;
}

void expect_same_where_both_are(const std::map<std::pair<long, long>, double>& part,
                                const std::map<std::pair<long, long>, double>& whole) {
    double most = 0;
    for (const auto& [place, moved] : whole) most = std::max(most, std::abs(moved));
    EXPECT_GT(most, 1e-4);
    for (const auto& [place, moved] : part) {
        ASSERT_TRUE(whole.contains(place));
        EXPECT_NEAR(moved, whole.at(place), 1e-6 * most);
    }
}

Texts held_at_both_ends() { return beam.with("Curve(\"clamp\") = {4}", "Curve(\"clamp\") = {2, 4}"); }

TEST(CellsInScenes, half_a_beam_at_a_plane_of_symmetry_bends_as_the_whole_one) {
    Texts half = beam.with("[numerics]", "symmetry = [\"x_high\"]\n[numerics]");
    for (const auto* corner : {"Point(2) = {4,", "Point(3) = {4,"})
        half = half.with(corner, std::string(corner).replace(12, 1, "2"));
    const auto whole = sag(held_at_both_ends()), part = sag(half);
    EXPECT_EQ(2 * part.size(), whole.size());
    expect_same_where_both_are(part, whole);
}

TEST(CellsInScenes, a_beam_through_a_period_is_held_by_its_own_image) {
    const auto whole = sag(held_at_both_ends());
    const auto endless = sag(beam.with("[numerics]", "periodic = [\"x\"]\n[numerics]"));
    EXPECT_EQ(endless.size(), whole.size());
    expect_same_where_both_are(endless, whole);
}

TEST(CellsInScenes, a_clamp_across_the_beam_holds_the_nodes_of_its_surface) {
    // Of a beam that is 0.45 m high the last row of nodes is 0.05 m above it.
    Texts low = beam;
    for (const auto* corner : {"{4, 0.5,", "{0, 0.5,"}) low = low.with(corner, std::string(corner).replace(6, 1, "45"));
    const Meshed meshed = mesh_texts(low);
    std::size_t clamped = 0;
    for (const CellNode& node : meshed.particles.cell_nodes) {
        EXPECT_EQ(node.fixed, node.position[0] == 0);
        clamped += node.fixed ? 1 : 0;
    }
    EXPECT_EQ(clamped, 5U);
    EXPECT_EQ(meshed.particles.cells.size(), 32U * 4);
}

/// Displacements at the end by particle, in axes turned by this angle with the beam and its weight.
std::vector<Vec> moved_in_turned_axes(double angle, const std::string& stepping) {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto text = [](double x, double y, const std::string& unit) {
        std::ostringstream out;
        out.precision(17);
        out << (unit.empty() ? "" : "\"") << x << unit << (unit.empty() ? ", " : "\", \"") << y << unit
            << (unit.empty() ? "" : "\"");
        return out.str();
    };
    Texts turned = beam.with("0, \"-1 m/s^2\"", text(s, -c, " m/s^2"))
                       .with("[numerics]", "[numerics]\nspring_stepping = \"" + stepping + "\"");
    for (const auto& [corner, x, y] : {std::tuple{"{4, 0,", 4.0, 0.0}, {"{4, 0.5,", 4.0, 0.5}, {"{0, 0.5,", 0.0, 0.5}})
        turned = turned.with(corner, "{" + text(c * x - s * y, s * x + c * y, "") + ",");
    const Meshed meshed = mesh_texts(turned);
    LastFrame sink;
    RunOptions options;
    options.sink = &sink;
    Simulation(meshed.scene, meshed.particles, Resources(1)).run(options);
    const FrameGroup& solid = *std::ranges::find(sink.last.groups, "solid", &FrameGroup::name);
    const FrameField& field = *std::ranges::find(solid.fields, "displacement", &FrameField::name);
    std::vector<Vec> moved(solid.id.size());
    for (std::size_t k = 0; k < solid.id.size(); ++k) {
        const Vec by(field.values[3 * k], field.values[3 * k + 1], 0);
        moved.at(static_cast<std::size_t>(solid.id[k])) = Vec(c * by[0] + s * by[1], c * by[1] - s * by[0], 0);
    }
    return moved;
}

TEST(CellsInScenes, a_beam_at_an_angle_moves_as_one_along_the_axes) {
    for (const char* stepping : {"implicit", "subcycled"}) {
        const std::vector<Vec> straight = moved_in_turned_axes(0, stepping);
        EXPECT_EQ(straight.size(), 32U * 4);
        double most = 0;
        for (const Vec& moved : straight) most = std::max(most, moved.norm());
        EXPECT_GT(most, 1e-2);
        for (const double angle : {0.35, -0.6}) {
            const std::vector<Vec> turned = moved_in_turned_axes(angle, stepping);
            ASSERT_EQ(turned.size(), straight.size());
            for (std::size_t n = 0; n < turned.size(); ++n)
                EXPECT_LT((turned[n] - straight[n]).norm(), 1e-5 * most) << n << " at " << angle << ", " << stepping;
        }
    }
}

TEST(CellsInScenes, a_load_that_crushes_a_cell_ends_the_run_with_its_place) {
    const Meshed meshed = mesh_texts(beam.with("20 MPa", "20 kPa").with("[0, \"-1 m/s^2\"]", "[\"-100 m/s^2\", 0]"));
    for (const SpringStepping stepping : {SpringStepping::implicit, SpringStepping::subcycled}) {
        Scene scene = meshed.scene;
        scene.numerics.spring_stepping = stepping;
        EXPECT_THAT(text_thrown<DivergenceError>([&] { Simulation(scene, meshed.particles, Resources(1)).run({}); }),
                    AllOf(HasSubstr("a cell of the elastic solid 'beam' near ("), HasSubstr("turned inside out"),
                          HasSubstr("youngs_modulus")));
    }
}

/// The beam without weight, under a force [N] on each particle of its last column, at 3.9375 m: the tip rises by 0.3 m,
/// and moves back by 15 mm.
Texts lifted_by_its_tip(const std::string& place, const std::string& force) {
    return beam.with("acceleration = [0, \"-1 m/s^2\"]\n", "")
        .with("20 1/s", "2 1/s")
        .with("[flow]", "[[force]]\nname = \"lift\"\npart = \"beam\"\namount = \"per_particle\"\nforce = [0, \"" +
                            place + " > 3.932 m ? " + force + " N : 0\"]\n[flow]");
}

TEST(CellsInScenes, a_load_on_the_tip_stays_on_it_where_it_asks_for_the_initial_place) {
    for (const bool springs : {false, true}) {
        const auto impulse = [&](const std::string& place) {
            Texts texts = lifted_by_its_tip(place, springs ? "400" : "600");
            if (springs)
                texts = texts.with("model = \"cells\"", "model = \"springs\"")
                            .with("poisson_ratio = 0.3", "poisson_ratio = 0.25");
            const Meshed meshed = mesh_texts(texts);
            return Simulation(meshed.scene, meshed.particles, Resources(1)).run({}).impulse_of_body_forces[1];
        };
        const double all = 4 * (springs ? 400 : 600);  // four particles, for a second
        EXPECT_NEAR(impulse("X"), all, 1e-9 * all);
        EXPECT_LT(impulse("x"), 0.9 * all) << "it has moved out from under the load";
    }
}

TEST(CellsInScenes, what_the_anchor_does_not_touch_is_refused) {
    const Texts apart = beam.with("Physical Curve(\"clamp\") = {4};",
                                  "Point(5) = {9, 9, 0};\nPoint(6) = {9, 10, 0};\nLine(5) = {5, 6};\n"
                                  "Physical Curve(\"clamp\") = {5};");
    EXPECT_THAT(text_thrown<InputError>([&] { mesh_texts(apart); }), HasSubstr("is next to 'clamp'"));
}

}  // namespace
}  // namespace dmp::tests::solver_cells_in_scenes_tests
