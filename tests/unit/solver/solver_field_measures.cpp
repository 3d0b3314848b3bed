// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the mean and extremes of a field, and the traction of the fluid on the faces of elastic solids.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_field_measures_tests {
namespace {

std::string measure(const std::string& name, const std::string& kind, const std::string& keys) {
    return "[[measure]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\n" + keys;
}

double value(const MeasureSeries& series, std::size_t row, const std::string& column) {
    const auto found = std::ranges::find(series.names, column);
    if (found == series.names.end()) throw std::logic_error("no column " + column);
    return series.rows.at(row).at(static_cast<std::size_t>(found - series.names.begin()));
}

MeasureSeries run(const Texts& texts, FrameSink* sink = nullptr) {
    const Meshed meshed = mesh_texts(texts);
    RunOptions options;
    options.sink = sink;
    return Simulation(meshed.scene, meshed.particles, Resources(1)).run(options).measures;
}

const std::string upper_half = "[[region]]\nname = \"upper\"\nfrom = [0, \"1 m\"]\nto = [\"4 m\", \"2 m\"]\n";

/// The channel, sheared at 0.5 / s at the start.
Texts sheared(const std::string& more) {
    Texts texts = channel.with("[flow]", "[flow]\ninitial_velocity = [\"-0.5 / (1 s) * y\", 0]");
    texts.scene += upper_half + more;
    return texts.with("duration = \"1 s\"", "duration = \"1 ms\"");
}

TEST(FieldMeasure, has_the_mean_the_extremes_and_where_the_highest_is) {
    const MeasureSeries series =
        run(sheared(measure("all", "field", "") + measure("above", "field", "region = \"upper\"\n")));
    EXPECT_THAT(series.names,
                testing::ElementsAre("all_mean", "all_low", "all_high", "all_high_x", "all_high_y", "above_mean",
                                     "above_low", "above_high", "above_high_x", "above_high_y"));
    // Rows of particles at (n + 1/2) / 8 m; the magnitude, though u < 0.
    EXPECT_NEAR(value(series, 0, "all_mean"), 0.5, 1e-12);
    EXPECT_NEAR(value(series, 0, "all_low"), 0.5 / 16, 1e-12);
    EXPECT_NEAR(value(series, 0, "all_high"), 0.5 * (2 - 1.0 / 16), 1e-12);
    EXPECT_NEAR(value(series, 0, "all_high_y"), 2 - 1.0 / 16, 1e-12);
    EXPECT_NEAR(value(series, 0, "above_mean"), 0.75, 1e-12);
    EXPECT_NEAR(value(series, 0, "above_low"), 0.5 * (1 + 1.0 / 16), 1e-12);
}

TEST(FieldMeasure, reads_stresses_without_frames_of_them) {
    const MeasureSeries series =
        run(sheared(measure("stress", "field", "field = \"shear_stress\"\nregion = \"middle\"\n") +
                    "[[region]]\nname = \"middle\"\nfrom = [0, \"0.6 m\"]\nto = [\"4 m\", \"1.4 m\"]\n")
                .with("1 mPa*s", "2 Pa*s"));
    for (const char* column : {"stress_low", "stress_mean", "stress_high"})  // 2 Pa s at 0.5 / s
        EXPECT_NEAR(value(series, series.rows.size() - 1, column), 1, 1e-3) << column;
}

TEST(FieldMeasure, where_there_is_no_fluid_has_no_value) {
    // The half of the box that the geometry leaves out.
    Texts texts = sheared(measure("none", "field", "region = \"outside\"\n") +
                          "[[region]]\nname = \"outside\"\nfrom = [0, \"1.99 m\"]\nto = [\"1 m\", \"4 m\"]\n");
    const MeasureSeries series = run(texts);
    for (const double each : series.rows.front()) EXPECT_TRUE(std::isnan(each));
    EXPECT_THAT(text_thrown<InputError>([&] { run(texts.with("1.99 m", "3 m")); }),
                testing::HasSubstr("region 'outside' of measure 'none' lies outside of all particles"));
}

TEST(FieldMeasure, refuses_what_has_no_largest_value) {
    const auto fault = [](const std::string& text) { return fault_of(sheared(text)); };
    EXPECT_EQ(
        fault(measure("m", "field", "field = \"stress\"\n")),
        "scene.toml:29:9: measure 'm' of kind 'field': 'stress' has several components, which have no largest one\n"
        "  measure 'von_mises', 'shear_stress' or 'pressure'");
    EXPECT_THAT(fault(measure("m", "field", "region = \"uper\"\n")),
                testing::HasSubstr("region of measure 'm': the scene has no region 'uper'\n  did you mean 'upper'?"));
    EXPECT_THAT(fault(measure("m", "field", "field = \"residence_time\"\n") +
                      "[[region]]\nname = \"low\"\nfrom = [0, 0]\nto = [\"1 m\", \"1 m\"]\n"),
                testing::HasSubstr("there are several regions, each with its own residence_time"));
    EXPECT_THAT(fault(measure("m", "field", "field = \"concentration\"\n")), testing::HasSubstr("no species"));
    EXPECT_THAT(fault(measure("m", "field", "species = \"oxygen\"\n")),
                testing::HasSubstr("measure 'm' has a species, and 'velocity' is of the fluid"));
    EXPECT_THAT(fault(measure("m", "solid_field", "part = \"water\"\n")),
                testing::HasSubstr("part 'water' is of kind 'fluid', expected 'elastic'"));
    for (const std::string field : {"stress", "principal_stretches", "mean_displacement"})
        EXPECT_THAT(
            fault_of({flap_channel.scene + measure("m", "solid_field", "part = \"flap\"\nfield = \"" + field + "\"\n"),
                      flap_channel.cad_geometry}),
            testing::HasSubstr("measure 'm' of kind 'solid_field': '" + field + "'"));
}

/// A free bar of 1 m x 1/4 m without stiffness that starts with this velocity.
Texts flying_bar(const std::string& model, const std::string& velocity) {
    return {
        "schema = 1\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = \"0.0625 "
        "m\"\n[[part]]\nname = \"bar\"\nkind = \"elastic\"\nmodel = \"" +
            model +
            "\"\ndensity = \"1000 kg/m^3\"\npoisson_ratio = 0.25\nyoungs_modulus = \"1 "
            "uPa\"\ninitial_velocity = " +
            velocity +
            "\n[flow]\nlargest_speed = \"2 m/s\"\n[numerics]\nsound_speed = \"20 m/s\"\n[contact]\nrange = "
            "0\n[run]\nduration = \"0.1 s\"\n[output]\nevery = \"0.1 s\"\n" +
            measure("speed", "solid_field", "part = \"bar\"\nfield = \"velocity\"\n") +
            measure("gone", "solid_field", "part = \"bar\"\n"),
        "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 0.25};\nPhysical Surface(\"bar\") = {1};\n"};
}

TEST(SolidFieldMeasure, is_of_particles) {
    for (const std::string model : {"springs", "cells"}) {
        const MeasureSeries series = run(flying_bar(model, "[\"0.3 m/s\", \"0.4 m/s\"]"));
        const std::size_t last = series.rows.size() - 1;
        EXPECT_NEAR(value(series, 0, "speed_mean"), 0.5, 1e-7);  // fields of frames are of single precision
        EXPECT_NEAR(value(series, 0, "speed_low"), 0.5, 1e-7);
        EXPECT_EQ(value(series, 0, "gone_high"), 0);
        EXPECT_NEAR(value(series, last, "gone_mean"), 0.05, 1e-7);
        EXPECT_NEAR(value(series, last, "gone_low"), 0.05, 1e-7);
    }
}

TEST(SolidFieldMeasure, is_of_bonds_where_it_says_so) {
    Texts pulled = flying_bar("springs", "[\"0.2 / (1 s) * x\", 0]");
    pulled.scene += measure("strain", "solid_field", "part = \"bar\"\nfield = \"strain\"\n");
    const MeasureSeries series = run(pulled);
    const std::size_t last = series.rows.size() - 1;
    EXPECT_NEAR(value(series, last, "strain_high"), 0.02, 1e-6);  // along x
    EXPECT_NEAR(value(series, last, "strain_low"), 0, 1e-6);      // along y
    // 16 x 4 particles: 15 x 4 bonds along x, 16 x 3 along y, 2 x 15 x 3 diagonals, which lengthen by about half.
    EXPECT_NEAR(value(series, last, "strain_mean"), (60 * 0.02 + 90 * (std::sqrt((1.02 * 1.02 + 1) / 2) - 1)) / 198,
                1e-6);
    Texts of_cells = flying_bar("cells", "[0, 0]");
    of_cells.scene += measure("strain", "solid_field", "part = \"bar\"\nfield = \"strain\"\n");
    EXPECT_THAT(fault_of(of_cells), testing::HasSubstr("'strain' is of bonds, and 'bar' consists of cells"));
}

/// A strip in the middle of the channel, from one periodic side to the other, between lids that slide in opposite
/// directions, as heavy as the water; gravity along -y.
Texts strip_between_lids() {
    Texts texts = channel
                      .with("name = \"wall\"\nkind = \"rigid\"\n",
                            "name = \"lower\"\nkind = \"rigid\"\nsurface_velocity = [\"-0.1 m/s\", 0]\n[[part]]\n"
                            "name = \"upper\"\nkind = \"rigid\"\nsurface_velocity = [\"0.1 m/s\", 0]\n")
                      .with("1 mPa*s", "1 kPa*s")
                      .with("[flow]", "[flow]\nacceleration = [0, \"-1 m/s^2\"]")
                      .with("largest_speed = \"1 m/s\"", "largest_speed = \"0.2 m/s\"")
                      .with("[run]", "[numerics]\nsound_speed = \"20 m/s\"\n[run]")
                      .with("duration = \"1 s\"", "duration = \"2 s\"")
                      .with("every = \"1 s\"", "every = \"2 s\"\nsolid_fields = [\"traction\"]")
                      .with("Physical Curve(\"wall\") = {1, 3};\n",
                            "Physical Curve(\"lower\") = {1};\nPhysical Curve(\"upper\") = {3};\nPoint(10) = {0, 1, "
                            "0};\nPoint(11) = {4, 1, 0};\nLine(10) = {10, 11};\nPhysical Curve(\"strip\") = {10};\n");
    texts.scene +=
        "[[part]]\nname = \"strip\"\nkind = \"elastic\"\nbending_stiffness = \"300 N*m^2\"\naxial_stiffness = \"1e4 "
        "N\"\n"
        "mass_per_length = \"250 kg/m\"\n" +
        measure("load", "solid_field", "part = \"strip\"\nfield = \"traction\"\n") +
        measure("in_water", "probe", "point = [\"2 m\", \"1.5 m\"]\nfield = \"shear_stress\"\n");
    return texts;
}

TEST(SurfaceTraction, has_the_shear_and_the_pressure_of_each_face) {
    KeptFrames kept;
    const MeasureSeries series = run(strip_between_lids(), &kept);
    const FrameGroup* solid = group_of(kept.frames.back(), "solid");
    ASSERT_NE(solid, nullptr);
    const auto traction = std::ranges::find(solid->fields, "traction", &FrameField::name);
    ASSERT_NE(traction, solid->fields.end());
    EXPECT_EQ(traction->components, 3);
    EXPECT_EQ(traction->unit, "Pa");
    std::array<Vec, 2> mean{Vec::Zero(), Vec::Zero()};  // of the lower and the upper face
    std::array<int, 2> count{};
    double largest = 0;
    for (std::size_t i = 0; i < solid->size(); ++i) {
        const std::size_t face = solid->position[3 * i + 1] > 1 ? 1 : 0;
        const Vec t(traction->values[3 * i], traction->values[3 * i + 1], traction->values[3 * i + 2]);
        mean[face] += t;
        ++count[face];
        largest = std::max(largest, t.norm());
    }
    for (std::size_t face : {0, 1}) {
        EXPECT_EQ(count[face], 32);
        mean[face] /= count[face];
    }
    // The water's own stress, which is the same everywhere; 114 Pa if the strip were as thick as two spacings.
    const double stress = value(series, series.rows.size() - 1, "in_water");
    EXPECT_NEAR(stress, 1000 * 0.1 / (1 - 0.125), 10);
    EXPECT_NEAR(mean[1][0], stress, 0.025 * stress);
    EXPECT_NEAR(mean[0][0], -stress, 0.025 * stress);
    EXPECT_NEAR(mean[0][1] + mean[1][1], 1000 * 0.25, 10);  // the difference of pressures carries the weight
    EXPECT_NEAR(value(series, series.rows.size() - 1, "load_high"), largest, 1e-6 * largest);
}

/// A stiff floor of 1/4 m, held from below, under water that gravity drives along x.
Texts floor_under_a_stream(const std::string& spacing) {
    Texts texts =
        channel
            .with("name = \"wall\"\nkind = \"rigid\"\n",
                  "name = \"wall\"\nkind = \"rigid\"\n[[part]]\nname = \"floor\"\n"
                  "kind = \"elastic\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = 0.3\n"
                  "anchor = \"bottom\"\n")
            .with("0.125 m", spacing)
            .with("1 mPa*s", "1 kPa*s")
            .with("[flow]", "[flow]\nacceleration = [\"1 m/s^2\", 0]")
            .with("largest_speed = \"1 m/s\"", "largest_speed = \"0.5 m/s\"")
            .with("duration = \"1 s\"", "duration = \"3 s\"");
    texts.scene += measure("load", "solid_field", "part = \"floor\"\nfield = \"traction\"\n");
    texts.cad_geometry =
        "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 4, 0.25};\nRectangle(2) = {0, 0.25, 0, 4, 1.75};\n"
        "BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }\nPhysical Surface(\"floor\") = {1};\n"
        "Physical Surface(\"water\") = {2};\n"
        "Physical Curve(\"bottom\") = Curve In BoundingBox{-1, -0.01, -1, 5, 0.01, 1};\n"
        "Physical Curve(\"wall\") = Curve In BoundingBox{-1, 1.99, -1, 5, 2.01, 1};\n";
    return texts;
}

/// Largest traction of a floor of 1/2 m under 1.5 m of water at rest, which both end at planes of symmetry or walls.
MeasureSeries under_still_water(const std::string& sides) {
    Texts texts = floor_under_a_stream("0.125 m")
                      .with("acceleration = [\"1 m/s^2\", 0]", "acceleration = [0, \"-1 m/s^2\"]")
                      .with("duration = \"3 s\"", "duration = \"20 ms\"")
                      .with("every = \"1 s\"", "every = \"20 ms\"")
                      .with("periodic = [\"x\"]", sides == "symmetry" ? "symmetry = [\"x_low\", \"x_high\"]" : "");
    if (sides == "walls")
        texts = texts
                    .with("BoundingBox{-1, 1.99, -1, 5, 2.01, 1};",
                          "BoundingBox{-1, 1.99, -1, 5, 2.01, 1};\nPhysical Curve(\"sides\") = {Curve In "
                          "BoundingBox{-0.01, -1, -1, 0.01, 3, 1}, Curve In BoundingBox{3.99, -1, -1, 4.01, 3, 1}};\n")
                    .with("[[part]]\nname = \"floor\"",
                          "[[part]]\nname = \"sides\"\nkind = \"rigid\"\n[[part]]\nname = \"floor\"");
    return run(texts);
}

TEST(SurfaceTraction, ends_with_the_liquid_at_walls_and_planes_of_symmetry) {
    for (const std::string sides : {"symmetry", "walls"}) {
        const MeasureSeries series = under_still_water(sides);
        const std::size_t last = series.rows.size() - 1;
        EXPECT_GT(value(series, last, "load_high"), 100) << sides;
        if (sides == "symmetry") {
            EXPECT_NEAR(value(series, last, "load_low") / value(series, last, "load_high"), 1, 0.02);
        }
        EXPECT_NEAR(value(series, last, "load_high_y"), 0.25 - 0.125 / 2, 0.02) << sides << ": on the surface";
    }
}

TEST(SurfaceTraction, of_a_parabola_is_half_of_what_drives_it) {
    for (const auto& [spacing, bound] : {std::pair("0.125 m", 0.02), {"0.0625 m", 0.01}}) {
        const MeasureSeries series = run(floor_under_a_stream(spacing));
        EXPECT_NEAR(value(series, series.rows.size() - 1, "load_high") / (1000 * 1.75 / 2), 1, bound) << spacing;
    }
}

}  // namespace
}  // namespace dmp::tests::solver_field_measures_tests
