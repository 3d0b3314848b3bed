// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The measure of an elastic solid as one body: its place, velocity, angle, length and stretches.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_body_measure_tests {
namespace {

/// A free bar of 1 m x 1/4 m (x 1/4 m) with its middle at (0.5, 0.125) m, that starts with this velocity.
Texts flying_bar(int dimension, const std::string& model, const std::string& modulus, const std::string& velocity) {
    const std::string drawn = dimension == 3 ? "Box(1) = {0, 0, 0, 1, 0.25, 0.25};\nPhysical Volume(\"bar\") = {1};\n"
                                             : "Rectangle(1) = {0, 0, 0, 1, 0.25};\nPhysical Surface(\"bar\") = {1};\n";
    return {
        "schema = 1\ntitle = \"bar\"\ndimension = " + std::to_string(dimension) +
            "\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = \"0.0625 m\"\n[[part]]\nname = "
            "\"bar\"\nkind = \"elastic\"\nmodel = \"" +
            model + "\"\ndensity = \"1000 kg/m^3\"\npoisson_ratio = 0.25\nyoungs_modulus = \"" + modulus +
            "\"\ninitial_velocity = " + velocity +
            "\n[flow]\nlargest_speed = \"2 m/s\"\n[numerics]\nsound_speed = \"20 m/s\"\n[contact]\nrange = "
            "0\n[run]\nduration = \"1 s\"\n[output]\nevery = \"1 s\"\nmeasure_every = \"0.05 s\"\n[[measure]]\nname = "
            "\"bar\"\nkind = \"body\"\npart = \"bar\"\n",
        "SetFactory(\"OpenCASCADE\");\n" + drawn};
}

/// The columns of the measure over time.
struct Followed {
    MeasureSeries series;

    [[nodiscard]] double at(std::size_t row, const std::string& column) const {
        const auto found = std::ranges::find(series.names, "bar_" + column);
        if (found == series.names.end()) throw std::logic_error("no column " + column);
        return series.rows.at(row).at(static_cast<std::size_t>(found - series.names.begin()));
    }
};

Followed follow(const Texts& texts) {
    const Meshed meshed = mesh_texts(texts);
    return {Simulation(meshed.scene, meshed.particles, Resources(1)).run({}).measures};
}

TEST(BodyMeasure, follows_a_stiff_body_through_many_turns) {
    for (const std::string model : {"cells", "springs"}) {
        constexpr double spin = 9;  // rad/s: nearly three turns in a second
        const Followed bar = follow(
            flying_bar(2, model, "1 GPa", "[\"0.5 m/s - 9 / (1 s) * (y - 0.125 m)\", \"9 / (1 s) * (x - 0.5 m)\"]"));
        ASSERT_EQ(bar.series.names.size(), 8U);
        for (std::size_t row = 0; row < bar.series.rows.size(); ++row) {
            const double t = bar.series.time[row];
            EXPECT_NEAR(bar.at(row, "angle"), spin * t, 0.01) << model << " at " << t;
            EXPECT_NEAR(bar.at(row, "x"), 0.5 + 0.5 * t, 1e-9);
            EXPECT_NEAR(bar.at(row, "y"), 0.125, 1e-9);
            EXPECT_NEAR(bar.at(row, "velocity_x"), 0.5, 1e-9);
            EXPECT_NEAR(bar.at(row, "velocity_y"), 0, 1e-9);
            EXPECT_NEAR(bar.at(row, "length"), 1 - 0.0625, 0.002);
            EXPECT_NEAR(bar.at(row, "least_stretch"), 1, 1e-3);
            EXPECT_NEAR(bar.at(row, "largest_stretch"), 1, 1e-3);
        }
    }
}

TEST(BodyMeasure, sees_a_soft_body_stretch_as_its_particles_fly_apart) {
    for (const int dimension : {2, 3}) {
        const std::string third = dimension == 3 ? ", 0" : "";
        const Followed bar =
            follow(flying_bar(dimension, "cells", "1 uPa",
                              "[\"0.2 / (1 s) * (x - 0.5 m)\", \"-0.1 / (1 s) * (y - 0.125 m)\"" + third + "]"));
        const std::size_t last = bar.series.rows.size() - 1;
        EXPECT_NEAR(bar.series.time[last], 1, 1e-9);
        EXPECT_NEAR(bar.at(last, "largest_stretch"), 1.2, 1e-6);
        EXPECT_NEAR(bar.at(last, "least_stretch"), 0.9, 1e-6);
        EXPECT_NEAR(bar.at(last, "length"), 1.2 * (1 - 0.0625), 1e-2);
        EXPECT_NEAR(bar.at(last, "angle"), 0, 1e-6);
    }
}

TEST(BodyMeasure, turns_in_space) {
    // About (1, 1, 1) / sqrt 3, by a quarter of a turn in a second.
    const std::string rate = "0.9068996821171089 / (1 s)";  // pi / 2 / sqrt 3
    const std::string x = "(x - 0.5 m)", y = "(y - 0.125 m)", z = "(z - 0.125 m)";
    const Followed bar = follow(flying_bar(3, "cells", "1 GPa",
                                           "[\"" + rate + " * (" + z + " - " + y + ")\", \"" + rate + " * (" + x +
                                               " - " + z + ")\", \"" + rate + " * (" + y + " - " + x + ")\"]"));
    // Not an axis of inertia: it does not go on about this one, but begins so.
    EXPECT_NEAR(bar.at(1, "angle"), 0.05 * 1.5707963267948966, 1e-3);
    EXPECT_NEAR(bar.at(bar.series.rows.size() - 1, "largest_stretch"), 1, 1e-3);
}

TEST(BodyMeasure, of_a_solid_through_a_periodic_side_is_refused) {
    for (const std::string model : {"cells", "springs"}) {
        const Texts through = flying_bar(2, model, "1 kPa", "[0, 0]").with("[flow]", "[flow]\nperiodic = [\"x\"]");
        EXPECT_THAT(text_thrown<InputError>([&] { follow(through); }),
                    testing::HasSubstr("goes on through a periodic side"))
            << model;
    }
}

TEST(BodyMeasure, of_what_turns_solid_begins_when_it_does) {
    Texts texts = channel.with("duration = \"1 s\"", "duration = \"0.05 s\"");
    texts.scene +=
        "measure_every = \"0.01 s\"\n[[region]]\nname = \"clotting\"\nfrom = [\"1 m\", \"0.5 m\"]\nto = [\"2 m\", "
        "\"1.5 m\"]\n[[solidify]]\nname = \"bar\"\nliquid = \"water\"\nseed_region = \"clotting\"\nregion = "
        "\"clotting\"\nreach = \"0.15 m\"\nprobability = 1\nfrom = \"0.025 s\"\ninterval = \"1000 s\"\nspreads = "
        "false\nbond_stiffness = \"1 kN/m\"\n[[measure]]\nname = \"bar\"\nkind = \"body\"\npart = \"bar\"\n";
    const Followed clot = follow(texts);
    for (const char* column : {"x", "velocity_y", "length"}) EXPECT_TRUE(std::isnan(clot.at(0, column))) << column;
    EXPECT_NEAR(clot.at(4, "x"), 1.5, 1e-6);
    EXPECT_NEAR(clot.at(4, "y"), 1, 1e-6);
    EXPECT_NEAR(clot.at(4, "velocity_y"), 0, 1e-6);
    EXPECT_GE(clot.at(4, "length"), 0.875 - 1e-6);  // a square has no longest axis: between its side and its diagonal
    EXPECT_LE(clot.at(4, "length"), std::hypot(0.875, 0.875) + 1e-6);
    for (const char* column : {"angle", "least_stretch", "largest_stretch"})
        EXPECT_TRUE(std::isnan(clot.at(4, column))) << column << ": it turned solid one particle after another";
}

}  // namespace
}  // namespace dmp::tests::solver_body_measure_tests
