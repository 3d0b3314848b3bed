// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// First-order uptake of species: its law, against closed forms, and its account.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "models/transport/species_uptake.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/dissolved.hpp"

namespace dmp::tests::solver_species_uptake_tests {
namespace {

constexpr std::array steppings{SpeciesStepping::explicitly, SpeciesStepping::implicitly};

Measure uptake_of(const std::string& name, const std::string& part) {
    Measure measure;
    measure.name = name;
    measure.kind = MeasureKind::uptake;
    if (!part.empty()) measure.part = part;
    return measure;
}

TEST(FirstOrderUptake, is_exact_for_a_supply_that_does_not_change) {
    for (const double x : {1e-12, 1e-3, 0.5, 3.0, 40.0, 800.0}) {
        const FirstOrderUptake law{x / 0.25};
        const double before = law.left_before(0.25), after = law.left_after(0.25);
        EXPECT_NEAR(before * after, std::exp(-x), 1e-15) << x;
        EXPECT_NEAR(after * x, -std::expm1(-x), 1e-15 * std::max(1.0, x)) << x;
        // w' = w where the supply r dt = x w makes up for the loss.
        EXPECT_NEAR((before + x) * after, 1, 1e-14) << x;
    }
    EXPECT_EQ(FirstOrderUptake{0}.left_before(0.25), 1);
    EXPECT_EQ(FirstOrderUptake{0}.left_after(0.25), 1);
}

/// Water with a layer of gel in it, both with drug 1; nothing comes in.
WalledWater closed_strip(double gel_rate, double water_rate) {
    WalledWater made = strip(12);
    make_part(made, "gel", PartKind::fluid, 0.6, 1.2);
    Species drug = species_of("drug", 0, "1");
    drug.uptake.parts = {{"gel", Value<double>(gel_rate)}, {"water", Value<double>(water_rate)}};
    made.scene.species = {drug};
    made.scene.run.duration = 1.0;
    return made;
}

TEST(Uptake, of_an_even_concentration_decays_exponentially_whatever_the_step) {
    for (const SpeciesStepping stepping : steppings)
        for (const double step_factor : {1.0, 0.1}) {
            WalledWater made = closed_strip(2, 0.5);
            made.scene.numerics.species_stepping = stepping;
            made.scene.numerics.step_factor = step_factor;
            KeptFrames frames;
            const RunSummary run = run_of(made, &frames);
            for (const auto& [x, value] : by_x(frames.frames.back()))
                EXPECT_NEAR(value, std::exp(x < 0.6 ? -0.5 : -2.0), 1e-7) << "at " << x;
            const double left = 0.8 * 0.6 * (std::exp(-2.0) + std::exp(-0.5));
            EXPECT_NEAR(run.species[0].end, left, 1e-11);
            EXPECT_NEAR(run.species[0].taken_up, 0.8 * 1.2 - left, 1e-11);
            EXPECT_EQ(run.species[0].residual(), 0) << "not a bit comes or goes";
        }
}

TEST(Uptake, is_measured_by_part) {
    WalledWater made = closed_strip(2, 0.5);
    made.scene.measures = {uptake_of("gel", "gel"), uptake_of("all", "")};
    made.scene.output.measure_every = 0.5;
    const RunSummary run = run_of(made);
    EXPECT_EQ(run.measures.names, (std::vector<std::string>{"gel", "gel_total", "all", "all_total"}));
    const auto& rows = run.measures.rows;
    ASSERT_EQ(rows.size(), 3U);
    const double in_gel = 0.8 * 0.6;
    EXPECT_NEAR(rows[1][1], in_gel * (1 - std::exp(-1.0)), 1e-9);
    EXPECT_NEAR(rows[2][1], in_gel * (1 - std::exp(-2.0)), 1e-9);
    EXPECT_NEAR(rows[2][0], in_gel * (std::exp(-1.0) - std::exp(-2.0)) / 0.5, 1e-9);
    EXPECT_NEAR(rows[2][3], rows[2][1] + in_gel * (1 - std::exp(-0.5)), 1e-9);
    EXPECT_EQ(rows[2][3], run.species[0].taken_up);
    EXPECT_EQ(rows[0][1], 0);
}

/// A slab between plates that are held at 1, L = 1 to its middle: Thiele (1939). The lattice's sums of the second
/// derivative, solved apart, are off by 0.0007, 0.0064 and 0.031 in the profile, 0.08, 0.8 and 3.9 % in the
/// effectiveness.
TEST(Uptake, between_plates_is_steady_at_Thieles_profile) {
    for (const SpeciesStepping stepping : steppings)
        for (const auto& [phi, profile, fraction] :
             {std::array{0.5, 0.001, 0.001}, {2.0, 0.007, 0.009}, {5.0, 0.033, 0.041}}) {
            WalledWater made = strip(20);
            Species drug = species_of("drug", 1, "1");
            drug.wall_concentration.parts = {{"left", placed("1")}, {"right", placed("1")}};
            drug.uptake.all = Value<double>(phi * phi);
            made.scene.species = {drug};
            made.scene.measures = {uptake_of("uptake", "")};
            made.scene.numerics.species_stepping = stepping;
            made.scene.run.duration = 6.0;
            made.scene.output.measure_every = 3.0;
            KeptFrames frames;
            const RunSummary run = run_of(made, &frames);
            for (const auto& [x, value] : by_x(frames.frames.back()))
                EXPECT_NEAR(value, std::cosh(phi * (x - 1)) / std::cosh(phi), profile) << "at " << x << ", phi " << phi;
            const double effectiveness = run.measures.rows.back()[0] / (phi * phi * 2 * 0.8);
            EXPECT_NEAR(effectiveness, std::tanh(phi) / phi, fraction * std::tanh(phi) / phi) << "phi " << phi;
            // The wall's particles have given more than 128 times the largest amount: beyond that they round.
            EXPECT_LT(std::abs(run.species[0].residual()), 1e-13);
        }
}

TEST(Uptake, much_faster_than_a_step_leaves_nothing_negative) {
    for (const SpeciesStepping stepping : steppings) {
        WalledWater made = strip(20);
        Species drug = species_of("drug", 1, "x < 1 ? 1 : 0");
        drug.wall_concentration.parts = {{"left", placed("1")}};
        drug.uptake.all = Value<double>(1e6);
        made.scene.species = {drug};
        made.scene.numerics.species_stepping = stepping;
        made.scene.run.duration = 0.2;
        KeptFrames frames;
        const RunSummary run = run_of(made, &frames);
        for (const auto& [x, value] : by_x(frames.frames.back())) {
            EXPECT_GE(value, 0) << x;
            EXPECT_LT(value, 1e-3) << x;
        }
        EXPECT_LT(std::abs(run.species[0].residual()), 1e-14);
        EXPECT_GT(run.species[0].taken_up, 1 * 0.8);
    }
}

TEST(Uptake, in_a_solid_that_conducts_takes_what_comes_through_the_liquid) {
    // 1 m of water, 0.6 m of tissue that takes up, 1 m of water; held at 1 and 0.
    WalledWater made = strip(26);
    make_part(made, "tissue", PartKind::rigid, 1.0, 1.6);
    Species drug = species_of("drug", 0, "1");
    drug.diffusivity.all.reset();
    drug.diffusivity.parts = {{"water", Value<double>(1.0)}, {"tissue", Value<double>(0.5)}};
    drug.wall_concentration.parts = {{"left", placed("1")}, {"right", placed("0")}};
    drug.uptake.parts = {{"tissue", Value<double>(2.0)}};
    made.scene.species = {drug};
    made.scene.run.duration = 12.0;
    made.scene.measures = {uptake_of("uptake", "tissue")};
    made.scene.output.measure_every = 6.0;
    KeptFrames frames;
    const RunSummary run = run_of(made, &frames);
    // c_1 and c_2 at the tissue's faces, from the fluxes there: with m = sqrt(k / D) = 2 and its thickness h,
    // D m (c_1 cosh(m h) - c_2) / sinh(m h) = 1 - c_1 and D m (c_1 - c_2 cosh(m h)) / sinh(m h) = c_2.
    const double a = 0.5 * 2 / std::sinh(1.2), b = 1 + a * std::cosh(1.2), c1 = b / (b * b - a * a),
                 c2 = a / (b * b - a * a);
    const double expected = ((1 - c1) - c2) * 0.8;
    EXPECT_NEAR(run.measures.rows.back()[0], expected, 0.01 * expected);
    for (const auto& [x, value] : by_x(frames.frames.back()))
        EXPECT_NEAR(value, x < 1.3 ? 1 - (1 - c1) * x : c2 * (2.6 - x), 0.01) << x;
    EXPECT_LT(std::abs(run.species[0].residual()), 1e-14);
}

TEST(Uptake, is_among_the_models_and_what_they_cost) {
    WalledWater made = closed_strip(2, 0);
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    const auto found = std::ranges::find(plan.models, "uptake of 'drug'", &ModelUse::model);
    ASSERT_NE(found, plan.models.end());
    EXPECT_NE(found->source.find("Cox & Matthews 2002"), std::string::npos);
    made.scene.species[0].uptake = {};
    for (const ModelUse& model : Simulation(made.scene, made.particles, 1).plan().models)
        EXPECT_EQ(model.model.find("uptake"), std::string::npos);
}

}  // namespace
}  // namespace dmp::tests::solver_species_uptake_tests
