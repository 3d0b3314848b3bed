// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The elastic bar behind a cylinder of Turek & Hron 2006 as the mesher makes it of a scene: CSM1, where it rests under
// its weight, and CSM3, how it swings from a start at rest.
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/solver/cell_bodies.hpp"

namespace dmp::tests::solver_bar_behind_cylinder_tests {
namespace {

using namespace cell_bodies;

constexpr double thickness = 0.02, end_x = 0.6, middle_y = 0.2;  // [m]

/// From a cylinder of radius 0.05 m around (0.2, 0.2) m to x = 0.6 m; alone, or in a channel that begins at x = 0.24 m.
Texts bar(int across, bool is_in_water, const std::string& more = "") {
    std::ostringstream scene;
    scene.precision(17);
    scene << "schema = 1\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = \"" << thickness / across
          << " m\"\n[[part]]\nname = \"bar\"\nkind = \"elastic\"\nmodel = \"cells\"\ndensity = \"1000 kg/m^3\"\n"
             "youngs_modulus = \"1.4 MPa\"\npoisson_ratio = 0.4\nanchor = \"root\"\n"
          << (is_in_water ? "[[part]]\nname = \"water\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\n"
                            "viscosity = \"1 Pa*s\"\n[[part]]\nname = \"wall\"\nkind = \"rigid\"\n"
                          : "")
          << "[flow]\nlargest_speed = \"0.5 m/s\"\nacceleration = [0, \"-2 m/s^2\"]\n[numerics]\n"
             "sound_speed = \"5 m/s\"\n[contact]\nrange = 0\n[run]\nduration = \"10 s\"\n[output]\nevery = \"10 s\"\n"
             "measure_every = \"5 ms\"\nfields = []\n"
          << more;
    const std::string alone = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {0.2, 0.19, 0, 0.4, 0.02};
Disk(2) = {0.2, 0.2, 0, 0.05, 0.05};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Physical Surface("bar") = {3};
e = 1e-4;
root() = Curve In BoundingBox {0.24, 0.19 - e, -e, 0.25 + e, 0.21 + e, e};
Physical Curve("root") = {root()};
)";
    const std::string water = R"(Rectangle(10) = {0.24, 0.1, 0, 0.46, 0.2};
Disk(12) = {0.2, 0.2, 0, 0.05, 0.05};
BooleanDifference(13) = { Surface{10}; Delete; }{ Surface{3, 12}; };
Recursive Delete { Surface{12}; }
Physical Surface("water") = {13};
all() = Boundary { Surface{13}; };
all() -= {Boundary { Surface{3}; }};
Physical Curve("wall") = {all(), root()};
)";
    return {scene.str(), is_in_water ? alone + water : alone};
}

/// How far the middle of its end has moved where it rests under its weight, without liquid. Of nodes above and below
/// the middle, where none stands on it, the mean.
Vec settled(const ParticleSet& set) {
    const Material material{1.4e6, 0.4, 1000};
    CellBody<2> body = body_of<2>(initial_cells(set, InitialSprings(set, material.part()), 0, 0));
    settle(body, on_nodes<2>(body, [](const Vec&, double mass) { return Vec(0, -2 * mass, 0); }), 4);
    const double off = set.cells.front().size[1] / 2;
    const auto& network = body.network();
    Vec sum = Vec::Zero();
    int nodes = 0;
    for (std::size_t n = 0; n < network.nodes(); ++n) {
        const Vec from = network.rest_position(n) - Vec(end_x, middle_y, 0);
        if (std::abs(from[0]) > 1e-9 || std::abs(from[1]) > 1.001 * off) continue;
        sum += network.displacement(n);
        ++nodes;
    }
    EXPECT_GT(nodes, 0) << "no node on the end";
    return sum / nodes;
}

TEST(BarBehindCylinder, hangs_as_in_the_benchmark_on_a_lattice_of_its_own) {
    for (const auto& [across, bound] : {std::pair{2, 0.007}, std::pair{4, 0.002}, std::pair{8, 0.003}}) {
        const Vec end = settled(mesh_texts(bar(across, false)).particles);
        EXPECT_NEAR(end[0] / -7.187e-3, 1, bound) << across << " across";
        EXPECT_NEAR(end[1] / -66.10e-3, 1, bound) << across << " across";
    }
}

TEST(BarBehindCylinder, has_its_lattice_in_a_liquid_too_whose_lattice_is_another) {
    for (const int across : {3, 4}) {
        const Meshed meshed = mesh_texts(bar(across, true));
        const ParticleSet& set = meshed.particles;
        const double a = thickness / across, drawn = meshed.geometry.region("bar")->area(),
                     liquid = meshed.geometry.region("water")->area();
        EXPECT_NEAR(settled(set)[1] / -66.10e-3, 1, 0.003) << across << " across";
        double solid = 0, all = 0, nearest = 1;
        for (std::size_t i = 0; i < set.size(); ++i) {
            if (set.kind(i) == PartKind::rigid) continue;
            all += set.volume[i];
            if (set.kind(i) == PartKind::elastic) {
                solid += set.volume[i];
                continue;
            }
            for (std::size_t j = 0; j < set.size(); ++j)
                if (set.kind(j) == PartKind::elastic)
                    nearest = std::min(nearest, (set.position[i] - set.position[j]).norm() / a);
        }
        // What is between the cylinder and the straight line through its ends counts as solid.
        const double radius = 0.05, angle = std::asin(thickness / 2 / radius);
        const double segment = radius * radius * (angle - std::sin(angle) * std::cos(angle));
        EXPECT_NEAR((solid - segment) / drawn, 1, 1e-4);
        EXPECT_NEAR(all / (drawn + liquid), 1, 0.001) << across << " across";
        EXPECT_GE(nearest, 0.9) << across << " across";
    }
}

TEST(BarBehindCylinder, swings_as_in_the_benchmark) {
    // From particles of the last two columns, above and below the middle: where the end is.
    const double a = thickness / 4;
    std::ostringstream measures;
    for (int n = 0; n < 4; ++n)
        measures << "[[measure]]\nname = \"p" << n << "\"\nkind = \"displacement\"\npart = \"bar\"\npoint = [\""
                 << end_x - (n < 2 ? 0.5 : 1.5) * a << " m\", \"" << middle_y + (n % 2 == 0 ? -0.5 : 0.5) * a
                 << " m\"]\n";
    const Meshed meshed = mesh_texts(bar(4, false, measures.str()));
    const RunSummary run = Simulation(meshed.scene, meshed.particles, Resources(1)).run({});
    ASSERT_EQ(run.measures.names,
              (std::vector<std::string>{"p0_x", "p0_y", "p1_x", "p1_y", "p2_x", "p2_y", "p3_x", "p3_y"}));
    double lowest = 0;
    std::vector<double> crossings;
    double before = 0;
    constexpr double mean = -63.6e-3;
    for (std::size_t k = 0; k < run.measures.time.size(); ++k) {
        const std::vector<double>& row = run.measures.rows[k];
        const double last = (row[1] + row[3]) / 2, next = (row[5] + row[7]) / 2;
        const double end = last + (last - next) / 2;
        lowest = std::min(lowest, end);
        if (k > 0 && before > mean && end <= mean)
            crossings.push_back(run.measures.time[k] -
                                (mean - end) / (before - end) * (run.measures.time[k] - run.measures.time[k - 1]));
        before = end;
    }
    ASSERT_GE(crossings.size(), 10U);
    const double frequency = static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
    EXPECT_NEAR(frequency / 1.0995, 1, 0.005);
    EXPECT_NEAR(lowest / -128.77e-3, 1, 0.01);
}

}  // namespace
}  // namespace dmp::tests::solver_bar_behind_cylinder_tests
