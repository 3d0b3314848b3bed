// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_measures_tests {
namespace {

Measure flux_line(const std::string& name, const Vec& from, const Vec& to) {
    Measure measure;
    measure.name = name;
    measure.kind = MeasureKind::flux;
    measure.from = from;
    measure.to = to;
    return measure;
}

Measure probe(const std::string& name, const Vec& point, FluidField field) {
    Measure measure;
    measure.name = name;
    measure.kind = MeasureKind::probe;
    measure.point = point;
    measure.field = field;
    return measure;
}

Measure measure_of(const std::string& name, MeasureKind kind, const std::string& part = "") {
    Measure measure;
    measure.name = name;
    measure.kind = kind;
    measure.part = part;
    return measure;
}

MeasureSeries measured(const SceneAndParticles& made) {
    Simulation simulation(made.scene, made.particles, 1);
    return simulation.run({}).measures;
}

/// Water that falls freely: u = 0.5 t along x everywhere, never disturbed.
SceneAndParticles falling(std::vector<Measure> measures) {
    SceneAndParticles made = endless_water("0.5");
    made.scene.measures = std::move(measures);
    return made;
}

TEST(Flux, of_uniform_flow_is_speed_times_length) {
    const auto series = measured(
        falling({flux_line("up", {0.43, 0.2, 0}, {0.43, 0.6, 0}), flux_line("down", {0.43, 0.6, 0}, {0.43, 0.2, 0}),
                 flux_line("along", {0.2, 0.4, 0}, {0.6, 0.4, 0})}));
    ASSERT_EQ(series.names, (std::vector<std::string>{"up", "down", "along"}));
    EXPECT_EQ(series.units, (std::vector<std::string>(3, "m^3/s")));
    for (std::size_t row = 0; row < series.time.size(); ++row) {
        const double expected = 0.5 * series.time[row] * 0.4;  // positive to the right of who walks along the line
        EXPECT_NEAR(series.rows[row][0], expected, 1e-12) << row;
        EXPECT_NEAR(series.rows[row][1], -expected, 1e-12) << row;
        EXPECT_NEAR(series.rows[row][2], 0, 1e-12) << row;
    }
}

TEST(Flux, sees_particles_across_a_periodic_border) {
    const auto series = measured(falling(
        {flux_line("at_border", {0, 0.2, 0}, {0, 0.6, 0}), flux_line("over_border", {0.05, 0.7, 0}, {0.05, 1.1, 0})}));
    for (std::size_t row = 0; row < series.time.size(); ++row)
        for (int column = 0; column < 2; ++column)
            EXPECT_NEAR(series.rows[row][column], 0.5 * series.time[row] * 0.4, 1e-12) << row << ", " << column;
}

TEST(Probe, of_uniform_fields_is_exact_anywhere) {
    const auto series = measured(falling(
        {probe("u", {0.313, 0.527, 0}, FluidField::velocity), probe("rho", {0.01, 0.79, 0}, FluidField::density),
         probe("p", {0.3, 0.3, 0}, FluidField::pressure), probe("tau", {0.3, 0.3, 0}, FluidField::shear_stress)}));
    ASSERT_EQ(series.names, (std::vector<std::string>{"u_x", "u_y", "rho", "p", "tau"}));
    EXPECT_EQ(series.units, (std::vector<std::string>{"m/s", "m/s", "kg/m^3", "Pa", "Pa"}));
    for (std::size_t row = 0; row < series.time.size(); ++row) {
        EXPECT_NEAR(series.rows[row][0], 0.5 * series.time[row], 1e-12);
        EXPECT_NEAR(series.rows[row][1], 0, 1e-12);
        EXPECT_NEAR(series.rows[row][2], 1000, 1e-9);
        EXPECT_NEAR(series.rows[row][3], 0, 1e-6);
        EXPECT_NEAR(series.rows[row][4], 0, 1e-9);
    }
}

TEST(Probe, of_tensors_and_regions_has_a_column_each) {
    SceneAndParticles made = falling(
        {probe("s", {0.3, 0.3, 0}, FluidField::stress), probe("w", {0.3, 0.3, 0}, FluidField::vorticity),
         probe("m", {0.3, 0.3, 0}, FluidField::von_mises), probe("r", {0.3, 0.3, 0}, FluidField::residence_time)});
    made.scene.regions.resize(2);
    made.scene.regions[0].name = std::string("all");
    made.scene.regions[0].to = Vec(1, 1, 0);
    made.scene.regions[1].name = std::string("none");
    made.scene.regions[1].from = Vec(2, 2, 0);
    made.scene.regions[1].to = Vec(3, 3, 0);
    const auto series = measured(made);
    ASSERT_EQ(series.names, (std::vector<std::string>{"s_xx", "s_yy", "s_zz", "s_xy", "w", "m", "r_all", "r_none"}));
    EXPECT_EQ(series.units, (std::vector<std::string>{"Pa", "Pa", "Pa", "Pa", "1/s", "Pa", "s", "s"}));
    for (std::size_t row = 0; row < series.time.size(); ++row) {
        for (int column = 0; column < 6; ++column) EXPECT_NEAR(series.rows[row][column], 0, 1e-6) << column;
        EXPECT_NEAR(series.rows[row][6], series.time[row], 1e-9);
        EXPECT_EQ(series.rows[row][7], 0);
    }
}

TEST(Probe, that_stands_outside_the_fluid_is_an_error) {
    SceneAndParticles made = endless_water("0");
    made.particles.periodic = {false, false, false};
    made.scene.measures = {probe("far", {5, 5, 0}, FluidField::pressure)};
    made.scene.measures[0].point.location = {"scene.toml", 12, 9};
    try {
        measured(made);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "the probe 'far' stands where there is no fluid");
        EXPECT_EQ(error.where().text(), "scene.toml:12:9");
        EXPECT_FALSE(error.what_to_do().empty());
    }
}

TEST(Probe, that_the_fluid_has_left_gives_no_number) {
    SceneAndParticles made = endless_water("0.5");
    made.particles.periodic = {false, false, false};
    made.particles.box.high[0] = 4;
    made.scene.numerics.shifting = 0.0;  // it would spread the free end
    made.scene.run.duration = 2.0;       // the fluid moves by 1 m
    made.scene.measures = {probe("start", {0.05, 0.4, 0}, FluidField::pressure)};
    const auto series = measured(made);
    EXPECT_FALSE(std::isnan(series.rows.front()[0]));
    EXPECT_TRUE(std::isnan(series.rows.back()[0]));
}

TEST(LargestSpeedAndDensity, of_uniform_flow) {
    const auto series =
        measured(falling({measure_of("fastest", MeasureKind::largest_speed), measure_of("rho", MeasureKind::density)}));
    ASSERT_EQ(series.names, (std::vector<std::string>{"fastest", "rho_low", "rho_high"}));
    EXPECT_EQ(series.units, (std::vector<std::string>{"m/s", "1", "1"}));
    for (std::size_t row = 0; row < series.time.size(); ++row) {
        EXPECT_NEAR(series.rows[row][0], 0.5 * series.time[row], 1e-12);
        EXPECT_NEAR(series.rows[row][1], 1, 1e-12);
        EXPECT_NEAR(series.rows[row][2], 1, 1e-12);
    }
}

TEST(KineticEnergy, of_uniform_flow) {
    const auto series = measured(falling({measure_of("energy", MeasureKind::kinetic_energy)}));
    ASSERT_EQ(series.names, std::vector<std::string>{"energy"});
    EXPECT_EQ(series.units, std::vector<std::string>{"J"});
    for (std::size_t row = 0; row < series.time.size(); ++row)
        EXPECT_NEAR(series.rows[row][0], 0.5 * 640 * std::pow(0.5 * series.time[row], 2), 1e-10);
}

/// A elastic solid without fluid, periodic in x with a period of 0.8 m.
SceneAndParticles flags_alone() {
    SceneAndParticles made = endless_water();
    const Box box = made.particles.box;
    made.particles = ParticleSet();
    made.particles.spacing = 0.1;
    made.particles.box = box;
    made.particles.periodic = {true, false, false};
    made.scene.flow.periodic = {true, false, false};
    add_flags(made);
    return made;
}

TEST(Gap, is_the_smallest_distance_between_two_bodies) {
    SceneAndParticles made = flags_alone();
    add_rod(made, {0.3, 0.2, 0}, 0);
    add_rod(made, {0.55, 0.45, 0}, 1);  // its lower end is 0.25 right of and 0.15 above the first one's upper end
    made.scene.measures = {measure_of("gap", MeasureKind::gap, "flags")};
    const auto series = measured(made);
    EXPECT_EQ(series.units, std::vector<std::string>{"m"});
    for (const auto& row : series.rows) EXPECT_NEAR(row[0], std::hypot(0.25, 0.15), 1e-12);
}

TEST(Gap, is_measured_across_a_periodic_border) {
    SceneAndParticles made = flags_alone();
    add_rod(made, {0.05, 0.2, 0}, 0);
    add_rod(made, {0.7, 0.2, 0}, 1);
    made.scene.measures = {measure_of("gap", MeasureKind::gap, "flags")};
    EXPECT_NEAR(measured(made).rows.at(0).at(0), 0.15, 1e-12);
}

TEST(Gap, of_a_part_that_is_left_out_has_no_column) {
    SceneAndParticles made = endless_water();
    Part flags;
    flags.name = std::string("flags");
    flags.kind = PartKind::elastic;
    flags.enabled = false;
    made.scene.parts.push_back(flags);
    made.scene.measures = {measure_of("gap", MeasureKind::gap, "flags"),
                           measure_of("fastest", MeasureKind::largest_speed)};
    made.scene.run.duration = 0.01;
    EXPECT_EQ(measured(made).names, std::vector<std::string>{"fastest"});
}

TEST(Displacement, of_a_body_that_falls) {
    SceneAndParticles made = flags_alone();
    made.scene.flow.acceleration[0] = Expression("0.2", "0.2");
    made.scene.contact.range = 0.0;
    add_rod(made, {0.3, 0.2, 0}, 0);
    Measure whole = measure_of("whole", MeasureKind::displacement, "flags"), tip = whole;
    tip.name = std::string("tip");
    tip.point = {Vec(0.31, 0.32, 0), {"scene.toml", 9, 9}};
    made.scene.measures = {whole, tip};
    const RunSummary run = Simulation(made.scene, made.particles, 1).run({});
    const MeasureSeries& series = run.measures;
    ASSERT_EQ(series.names, (std::vector<std::string>{"whole_x", "whole_y", "tip_x", "tip_y"}));
    EXPECT_EQ(series.units, (std::vector<std::string>(4, "m")));
    // Spring bodies take whole kicks: half a step ahead of the velocity (docs/architecture.md, "The step").
    const double dt = *made.scene.run.duration / static_cast<double>(run.steps);
    for (std::size_t row = 0; row < series.time.size(); ++row)
        for (const std::size_t first : {0U, 2U}) {
            EXPECT_NEAR(series.rows[row][first], 0.1 * series.time[row] * (series.time[row] + dt), 1e-9);
            EXPECT_NEAR(series.rows[row][first + 1], 0, 1e-12);
        }
}

TEST(Displacement, of_a_solid_alone_is_not_limited_by_its_box) {
    SceneAndParticles made = flags_alone();
    std::erase_if(made.scene.parts, [](const Part& part) { return *part.kind == PartKind::fluid; });
    made.scene.flow.acceleration[1] = Expression("-20", "-20");
    made.scene.numerics.sound_speed = 100.0;
    made.scene.contact.range = 0.0;
    add_rod(made, {0.3, 0.2, 0}, 0);
    made.scene.measures = {measure_of("fall", MeasureKind::displacement, "flags")};
    EXPECT_NEAR(measured(made).rows.back()[1], -10, 0.1);
}

TEST(Displacement, at_a_point_is_that_of_the_nearest_particle) {
    SceneAndParticles made = flags_alone();
    add_rod(made, {0.3, 0.2, 0}, 0);
    made.particles.fixed[made.particles.size() - 2] = 1;  // its lower end
    made.scene.flow.acceleration[0] = Expression("0.2", "0.2");
    Measure low = measure_of("low", MeasureKind::displacement, "flags"), high = low;
    low.point = {Vec(0.3, 0.21, 0), {"scene.toml", 9, 9}};
    high.name = std::string("high");
    high.point = {Vec(0.3, 0.29, 0), {"scene.toml", 10, 9}};
    made.scene.measures = {low, high};
    const auto series = measured(made);
    EXPECT_EQ(series.rows.back()[0], 0);
    EXPECT_GT(series.rows.back()[2], 0.01);
}

TEST(Displacement, of_a_point_outside_is_an_error) {
    SceneAndParticles made = flags_alone();
    add_rod(made, {0.3, 0.2, 0}, 0);
    made.scene.measures = {measure_of("far", MeasureKind::displacement, "flags")};
    made.scene.measures[0].point = {Vec(0.7, 0.6, 0), {"scene.toml", 9, 9}};
    try {
        measured(made);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.where().text(), "scene.toml:9:9");
        EXPECT_THAT(error.what(), ::testing::HasSubstr("is not in 'flags'"));
    }
}

TEST(MeasureRows, come_at_measure_every_or_four_times_a_frame) {
    SceneAndParticles made = falling({measure_of("fastest", MeasureKind::largest_speed)});
    made.scene.output.every = 0.3;
    made.scene.output.measure_every = 0.1;
    auto series = measured(made);
    ASSERT_EQ(series.time.size(), 11U);
    for (std::size_t k = 0; k < series.time.size(); ++k)
        EXPECT_NEAR(series.time[k], 0.1 * static_cast<double>(k), 1e-12);
    ASSERT_EQ(series.rows.size(), series.time.size());

    made.scene.output.measure_every = 0.0;
    made.scene.output.every = 0.5;
    series = measured(made);
    ASSERT_EQ(series.time.size(), 9U);
    EXPECT_NEAR(series.time[1], 0.125, 1e-12);
}

}  // namespace
}  // namespace dmp::tests::solver_measures_tests
