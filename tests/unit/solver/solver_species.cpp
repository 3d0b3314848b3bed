// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Diffusion of species against closed forms, in liquids at rest and between walls.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/dissolved.hpp"
#include "tests/unit/solver/mirrored_water.hpp"

namespace dmp::tests::solver_species_tests {
namespace {

constexpr double dx = 0.1;

/// Root mean square and largest difference between the last frame and c(x).
template <class Exact>
std::pair<double, double> errors(const Frame& frame, const Exact& exact) {
    double square = 0, largest = 0;
    const auto found = by_x(frame);
    for (const auto& [x, value] : found) {
        const double error = std::abs(value - exact(x));
        square += error * error / static_cast<double>(found.size());
        largest = std::max(largest, error);
    }
    return {std::sqrt(square), largest};
}

/// A step between D1 = 1 m^2/s, on the left with concentration 1, and D2 with 0, at the time t. Lucy's kernel with a
/// support of three spacings, for which the errors on a lattice are known from a calculation of its own.
struct Step {
    double ratio;         ///< D1 / D2
    double t;             ///< [dx^2 / D1]
    double rms, largest;  ///< bounds of errors
};

class DiffusionOfAStep : public testing::TestWithParam<Step> {};

TEST_P(DiffusionOfAStep, follows_the_closed_form) {
    const Step& step = GetParam();
    WalledWater made = strip(240, 6);
    make_part(made, "slow", PartKind::fluid, 12.0, 24.0);
    made.scene.numerics.kernel = KernelKind::lucy;
    made.scene.numerics.scheme = FluidScheme::plain;  // Lucy's kernel has no other
    made.scene.numerics.viscous_law = ViscousLaw::of<MorrisViscosity>();
    Species drug = species_of("drug", 1, "x < 12 ? 1 : 0");
    drug.diffusivity.all.reset();
    drug.diffusivity.parts = {{"water", 1.0}, {"slow", 1.0 / step.ratio}};
    made.scene.species = {drug};
    const double t = step.t * dx * dx, d1 = 1, d2 = 1 / step.ratio;
    made.scene.run.duration = t;
    KeptFrames frames;
    const RunSummary run = run_of(made, &frames);
    EXPECT_EQ(run.ruling_limit, "species");

    const double at_interface = std::sqrt(d1) / (std::sqrt(d1) + std::sqrt(d2));
    const auto exact = [&](double x) {
        return x < 12 ? 1 - (1 - at_interface) * std::erfc((12 - x) / (2 * std::sqrt(d1 * t)))
                      : at_interface * std::erfc((x - 12) / (2 * std::sqrt(d2 * t)));
    };
    const auto [rms, largest] = errors(frames.frames.back(), exact);
    EXPECT_LT(rms, step.rms);
    EXPECT_LT(largest, step.largest);
    // The flux D dc/dx is one on both sides: the concentration between the two rows nearest to the interface.
    const auto found = by_x(frames.frames.back());
    const auto right = found.lower_bound(12.0F);
    const double found_interface = (d1 * std::prev(right)->second + d2 * right->second) / (d1 + d2);
    EXPECT_NEAR(found_interface, at_interface, 0.01 * at_interface);
    EXPECT_EQ(run.species.at(0).residual(), 0) << "not a bit comes or goes";
    EXPECT_NEAR(run.species.at(0).start, 12 * 6 * dx, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Species, DiffusionOfAStep,
                         // At a jump of 100 the layer in the slow part is a spacing and a half deep at this time.
                         testing::Values(Step{1, 60, 6.2e-5, 2e-4}, Step{10, 600, 6.2e-4, 3.8e-3},
                                         Step{100, 60, 0.02, 0.15}));

TEST(Diffusion, of_a_gaussian_spreads_its_variance) {
    WalledWater made(40, 40, {}, [](int, int) { return 0; });
    made.make_periodic(0);
    made.make_periodic(1);
    made.scene.species = {species_of("dye", 1, "exp(-((x-2)^2 + (y-2)^2) / (2*0.09))")};
    made.scene.numerics.shifting = 0.0;
    made.scene.output.fields = {FluidField::concentration};
    Measure spread;
    spread.name = std::string("spread");
    spread.kind = MeasureKind::spread;
    spread.axis = Axis::y;
    Measure total;
    total.name = std::string("total");
    total.kind = MeasureKind::amount;
    made.scene.measures = {spread, total};
    made.scene.output.measure_every = 0.01;
    made.scene.run.duration = 0.1;
    KeptFrames frames;
    const RunSummary run = run_of(made, &frames);
    const auto& rows = run.measures.rows;
    ASSERT_EQ(rows.size(), 11U);
    EXPECT_EQ(run.measures.names,
              (std::vector<std::string>{"spread", "spread_diffusivity", "spread_sherwood", "total"}));
    EXPECT_NEAR(rows.front()[0], 0.09, 1e-6);
    // The lattice sum of the Laplacian of y^2 / 2 is 1 within a per cent, as for viscosity.
    EXPECT_NEAR(rows.back()[0], 0.09 + 2 * 0.1, 0.01 * 0.2);
    EXPECT_NEAR(rows.back()[1], 1, 0.01);
    EXPECT_EQ(rows.back()[2], rows.back()[1]);
    EXPECT_EQ(rows.back()[3], rows.front()[3]);
    double highest = 0;
    for (const float value : field_of(*group_of(frames.frames.back(), "fluid"), "concentration")->values)
        highest = std::max<double>(highest, value);
    const double exact_peak = 0.09 / 0.29 * std::exp(-2 * 0.05 * 0.05 / (2 * 0.29));
    EXPECT_NEAR(highest, exact_peak, 0.01 * exact_peak);
}

/// Between plates held at 1 and 0, from 0: the series of a slab.
double between_plates(double x, double t) {
    double c = 1 - x;
    for (int n = 1; n < 200; ++n)
        c -= 2 / (n * std::numbers::pi) * std::sin(n * std::numbers::pi * x) *
             std::exp(-std::pow(n * std::numbers::pi, 2) * t);
    return c;
}

WalledWater plates(int columns) {
    WalledWater made = strip(columns);
    Species drug = species_of("drug", 1, "0");
    drug.wall_concentration.parts = {{"left", placed("1")}, {"right", placed("0")}};
    made.scene.species = {drug};
    return made;
}

TEST(Diffusion, between_plates_that_are_held_follows_the_series) {
    for (const double t : {0.05, 0.2, 1.0}) {
        WalledWater made = plates(20);  // 2 m wide
        made.scene.run.duration = 4 * t;
        KeptFrames frames;
        const RunSummary run = run_of(made, &frames);
        const auto [rms, largest] = errors(frames.frames.back(), [t](double x) { return between_plates(x / 2, t); });
        EXPECT_LT(rms, 0.005) << t;
        EXPECT_LT(largest, 0.01) << t;
        EXPECT_LT(std::abs(run.species[0].residual()), 1e-15);
        EXPECT_GT(run.species[0].from_walls, 0);
    }
}

TEST(Diffusion, into_a_wall_is_measured_with_its_sherwood_number) {
    WalledWater made = plates(20);
    Measure flux;
    flux.name = std::string("uptake");
    flux.kind = MeasureKind::wall_flux;
    flux.part = std::string("right");
    flux.length = {2.0, SourceLocation{"scene.toml", 9, 1}};
    flux.area = {0.8, SourceLocation{"scene.toml", 9, 1}};
    made.scene.measures = {flux};
    made.scene.output.measure_every = 0.5;
    made.scene.run.duration = 6.0;
    const RunSummary run = run_of(made);
    const auto& last = run.measures.rows.back();
    const double expected = 1 * 1.0 / 2 * 0.8;  // D dc / L times the area
    EXPECT_NEAR(last[0], expected, 0.005 * expected);
    EXPECT_NEAR(last[2], 2, 0.01) << "the mean lies half as high as the other wall";
    double total = 0;
    for (std::size_t row = 1; row < run.measures.rows.size(); ++row)
        total += run.measures.rows[row][0] * (run.measures.time[row] - run.measures.time[row - 1]);
    EXPECT_NEAR(total, last[1], 1e-12 * last[1]);
}

TEST(Diffusion, of_a_flux_out_of_a_wall_gives_what_was_asked_for) {
    WalledWater made = strip(30);
    Species drug = species_of("drug", 1, "0");
    drug.wall_flux.parts = {{"left", placed("2.5")}};
    made.scene.species = {drug};
    made.scene.run.duration = 0.5;
    KeptFrames frames;
    const RunSummary run = run_of(made, &frames);
    EXPECT_NEAR(run.species[0].end, 2.5 * 0.8 * 0.5, 0.01 * 2.5 * 0.8 * 0.5);
    EXPECT_LT(std::abs(run.species[0].residual()), 1e-15);
    // Into a half space: c = 2 J sqrt(t / D) ierfc(x / (2 sqrt(D t))).
    const auto [rms, largest] = errors(frames.frames.back(), [](double x) {
        const double z = x / (2 * std::sqrt(0.5));
        return 2 * 2.5 * std::sqrt(0.5) * (std::exp(-z * z) / std::sqrt(std::numbers::pi) - z * std::erfc(z));
    });
    EXPECT_LT(rms, 0.02);
    EXPECT_LT(largest, 0.05);
}

TEST(Diffusion, through_a_solid_that_conducts_is_stationary_in_series) {
    // 1 m of water, 0.6 m of solid of half the diffusivity, 1 m of water: the resistances add up.
    WalledWater made = plates(26);
    make_part(made, "membrane", PartKind::rigid, 1.0, 1.6);
    made.scene.species[0].diffusivity.all.reset();
    made.scene.species[0].diffusivity.parts = {{"water", 1.0}, {"membrane", 0.5}};
    made.scene.run.duration = 12.0;
    KeptFrames frames;
    const RunSummary run = run_of(made, &frames);
    const double flux = 1 / (1 + 0.6 / 0.5 + 1);
    const auto [rms, largest] =
        errors(frames.frames.back(), [&](double x) { return x < 1.3 ? 1 - flux * x : flux * (2.6 - x); });
    EXPECT_LT(largest, 0.01);
    EXPECT_LT(std::abs(run.species[0].residual()), 1e-15);
}

TEST(Diffusion, does_not_pass_a_solid_that_is_closed) {
    WalledWater made = strip(26);
    make_part(made, "membrane", PartKind::rigid, 1.0, 1.6);
    made.scene.species = {species_of("drug", 1, "x < 1 ? 1 : 0")};
    made.scene.run.duration = 1.0;
    KeptFrames frames;
    const RunSummary run = run_of(made, &frames);
    for (const auto& [x, value] : by_x(frames.frames.back())) EXPECT_NEAR(value, x < 1 ? 1 : 0, 1e-13) << x;
    EXPECT_EQ(run.species[0].residual(), 0);
}

TEST(Diffusion, stepped_implicitly_gives_the_same_and_keeps_every_bit) {
    WalledWater made = plates(20);
    made.scene.run.duration = 0.4;
    KeptFrames explicitly, implicitly;
    const RunSummary first = run_of(made, &explicitly);
    made.scene.numerics.species_stepping = SpeciesStepping::implicitly;
    made.scene.numerics.step_factor = 0.05;
    const RunSummary second = run_of(made, &implicitly);
    EXPECT_EQ(second.ruling_limit, "sound");
    EXPECT_GT(second.species_solves.mean_iterations(), 1);
    // Both steps are of first order, from either side: 2 dt |dc/dt|.
    const auto one = by_x(explicitly.frames.back());
    for (const auto& [x, value] : by_x(implicitly.frames.back())) EXPECT_NEAR(value, one.at(x), 3e-3) << x;
    EXPECT_LT(std::abs(second.species[0].residual()), 1e-15);
    // A hundred times the explicit limit: to the steady state at once.
    made.scene.numerics.step_factor = 1.0;
    made.scene.species[0].diffusivity.all = Value<double>(100.0);
    KeptFrames fast;
    const RunSummary third = run_of(made, &fast);
    EXPECT_LT(third.steps, 60);
    for (const auto& [x, value] : by_x(fast.frames.back())) EXPECT_NEAR(value, 1 - x / 2, 1e-3) << x;
    EXPECT_LT(std::abs(third.species[0].residual()), 1e-14);
}

TEST(Diffusion, leaves_an_even_concentration_alone_in_a_stirred_liquid) {
    SceneAndParticles made = endless_water("sin(2*pi*t)");
    made.scene.species = {species_of("drug", 0.1, "0.7")};
    made.scene.flow.initial_velocity = std::array<Expression, 3>{
        Expression("sin(2*3.14159265*y/0.8)", ""), Expression("sin(2*3.14159265*x/0.8)", ""), Expression()};
    made.scene.flow.largest_speed = 2.0;
    made.scene.output.fields = {FluidField::concentration};
    KeptFrames frames;
    Simulation simulation(made.scene, made.particles, 1);
    RunOptions options;
    options.sink = &frames;
    const RunSummary run = simulation.run(options);
    for (const float value : field_of(*group_of(frames.frames.back(), "fluid"), "concentration")->values)
        EXPECT_NEAR(value, 0.7F, 1e-7);
    EXPECT_EQ(run.species[0].end, run.species[0].start);
}

TEST(Species, alone_are_stepped_in_a_fluid_at_rest) {
    const auto made_with = [](const std::string& viscosity) {
        auto made = case_of("verification/diffusion", {"part.air.viscosity=\"" + viscosity + "\""});
        made.scene.run.duration = 0.2;
        made.scene.output.every = 0.1;
        return made;
    };
    const auto thin = made_with("18 uPa*s");
    Simulation simulation(thin.scene, thin.particles, 1);
    const Plan plan = simulation.plan();
    EXPECT_TRUE(plan.at_rest);
    ASSERT_EQ(plan.limits.size(), 1U);
    EXPECT_EQ(plan.limits[0].model, "species");
    for (const ModelUse& model : plan.models) EXPECT_EQ(model.model.find("viscous"), std::string::npos) << model.model;
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    const RunSummary summary = simulation.run(options);
    const FrameGroup &before = *group_of(kept.frames.front(), "fluid"), &after = *group_of(kept.frames.back(), "fluid");
    EXPECT_EQ(before.position, after.position);
    EXPECT_NE(field_of(before, "concentration")->values, field_of(after, "concentration")->values);
    EXPECT_EQ(summary.largest_speed, 0);

    // A viscosity a million times as large changes neither the steps nor the result.
    const auto thick = made_with("18 Pa*s");
    const RunSummary of_thick = Simulation(thick.scene, thick.particles, 1).run({});
    EXPECT_EQ(of_thick.steps, summary.steps);
    EXPECT_EQ(of_thick.measures.rows, summary.measures.rows);

    // Whatever may move is stepped.
    const auto driven = case_of("verification/diffusion", {"flow.pressure_gradient=[\"-1 Pa/m\", 0]"});
    EXPECT_FALSE(Simulation(driven.scene, driven.particles, 1).plan().at_rest);
}

TEST(Species, that_walls_are_closed_to_do_not_feel_others_that_walls_hold) {
    SceneAndParticles made = stirred_mixture();
    made.scene.species[1].concentration.all = placed("0.7");
    KeptFrames frames;
    Simulation simulation(made.scene, made.particles, 1);
    RunOptions options;
    options.sink = &frames;
    const RunSummary run = simulation.run(options);
    EXPECT_GT(std::abs(run.species[0].from_walls), 0);
    const std::string field = "concentration_marker";
    for (const float value : field_of(*group_of(frames.frames.back(), "fluid"), field)->values)
        EXPECT_NEAR(value, 0.7F, 1e-7);
}

TEST(Species, go_on_from_a_checkpoint_to_the_same_bits) {
    for (const SpeciesStepping stepping : {SpeciesStepping::explicitly, SpeciesStepping::implicitly}) {
        const auto folder = std::filesystem::path(testing::TempDir()) / "dmp_species";
        std::filesystem::remove_all(folder);
        SceneAndParticles made = stirred_mixture();
        made.scene.numerics.species_stepping = stepping;
        KeptFrames kept;
        const RunSummary whole = run_of(made, &kept);
        const RunSummary parts = run_in_two_parts(made, folder);
        std::filesystem::remove_all(folder);
        EXPECT_EQ(parts.state_hash, whole.state_hash);
        for (std::size_t s = 0; s < 3; ++s) {
            EXPECT_EQ(parts.species[s].end, whole.species[s].end);
            EXPECT_EQ(parts.species[s].start, whole.species[s].start);
            EXPECT_EQ(parts.species[s].taken_up, whole.species[s].taken_up);
            EXPECT_EQ(parts.species[s].from_walls, whole.species[s].from_walls);
        }
        EXPECT_GT(whole.species[0].taken_up, 1e-3);
        ASSERT_EQ(parts.measures.rows.size(), whole.measures.rows.size());
        for (std::size_t row = 1; row < whole.measures.rows.size(); ++row)
            EXPECT_EQ(parts.measures.rows[row], whole.measures.rows[row]);
        for (const SpeciesBalance& species : whole.species)
            // What waits for the next step: the rounding of what each of 168 particles gives back, 2^-52 of the
            // largest.
            EXPECT_LT(std::abs(species.residual()), 1e-13) << species.name;
        EXPECT_GT(std::abs(whole.species[0].from_walls), 1e-4);
    }
}

TEST(Species, refuse_a_start_that_is_no_concentration) {
    WalledWater made = strip(10);
    made.scene.species = {species_of("drug", 1, "x - 0.3")};
    try {
        (void)Simulation(made.scene, made.particles, 1);
        FAIL() << "taken";
    } catch (const InputError& error) {
        EXPECT_EQ(error.where().text(), "scene.toml:7:3");
        EXPECT_NE(error.problem().find("species 'drug': concentration is -0.25 at x = 0.05"), std::string::npos)
            << error.problem();
    }
}

TEST(Species, cost_nothing_where_there_are_none) {
    SceneAndParticles made = stirred_mixture();
    const Plan with = Simulation(made.scene, made.particles, 1).plan();
    made.scene.species.clear();
    made.scene.measures.clear();
    made.scene.output.fields = {FluidField::velocity};
    const Plan without = Simulation(made.scene, made.particles, 1).plan();
    const auto has_any = [](const Plan& plan) {
        return std::ranges::any_of(plan.fields, [](const std::string& field) {
            return field.find("species") != std::string::npos || field.find("concentration") != std::string::npos;
        });
    };
    EXPECT_TRUE(has_any(with));
    EXPECT_FALSE(has_any(without));
    EXPECT_GT(with.bytes_per_particle, without.bytes_per_particle);
    const auto diffusion = std::ranges::find(with.models, "diffusion of 'drug'", &ModelUse::model);
    ASSERT_NE(diffusion, with.models.end());
    EXPECT_FALSE(diffusion->fields.empty());
    EXPECT_TRUE(std::ranges::any_of(with.limits, [](const StepLimit& limit) { return limit.model == "species"; }));
    EXPECT_FALSE(std::ranges::any_of(without.limits, [](const StepLimit& limit) { return limit.model == "species"; }));
}

TEST(Species, are_mirrored_at_planes_of_symmetry) {
    WalledWater half = vortex(true), whole = vortex(false);
    for (WalledWater* made : {&half, &whole}) {
        made->scene.species = {species_of("dye", 0.05, "cos(pi * x) * cos(2 * pi * y) + 2")};
        made->scene.output.fields = {FluidField::concentration};
    }
    KeptFrames of_half, of_whole;
    const RunSummary run = run_of(half, &of_half);
    (void)run_of(whole, &of_whole);
    EXPECT_LT(std::abs(run.species[0].residual()), 1e-14);
    const FrameGroup &quarter = *group_of(of_half.frames.back(), "fluid"),
                     &all = *group_of(of_whole.frames.back(), "fluid");
    const auto &found = field_of(quarter, "concentration")->values, &expected = field_of(all, "concentration")->values;
    for (std::size_t k = 0; k < quarter.size(); ++k) {
        double nearest = 1, value = 0;
        for (std::size_t j = 0; j < all.size(); ++j) {
            const double distance = std::hypot(all.position[3 * j] - quarter.position[3 * k],
                                               all.position[3 * j + 1] - quarter.position[3 * k + 1]);
            if (distance < nearest) nearest = distance, value = expected[j];
        }
        EXPECT_NEAR(found[k], value, 1e-4) << "at " << quarter.position[3 * k] << ", " << quarter.position[3 * k + 1];
    }
}

/// Sheared between a wall and a lid at Re = 100, from a disordered start, in which shifting brings particles back into
/// rows; a marker that does not diffuse and whose concentration grows straight across the flow.
TEST(Shifting, leaves_behind_what_is_dissolved) {
    constexpr int rows = 16;
    constexpr double height = rows * dx;
    WalledWater made(rows, rows, {"floor", "lid"}, [](int column, int row) {
        return column < 0 || column >= rows ? 0 : row < 0 ? 1 : 2;
    });
    made.make_periodic(0);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-0.2 * dx, 0.2 * dx);
    for (std::size_t i = 0; i < made.particles.size(); ++i)
        for (int axis = 0; axis < 2; ++axis)
            if (made.particles.part[i] == 0) made.particles.position[i][axis] += jitter(random);
    Scene& scene = made.scene;
    scene.parts[0].viscosity = 1000 * height / 100;
    scene.parts[2].surface_velocity = std::array<Expression, 3>{Expression("1", "1"), Expression(), Expression()};
    scene.flow.initial_velocity = std::array<Expression, 3>{Expression("y / 1.6", ""), Expression(), Expression()};
    scene.species = {species_of("marker", 0, "y / 1.6")};
    scene.numerics.shifting = 4.0;
    scene.output.fields = {FluidField::concentration};
    scene.run.duration = 5.0;
    KeptFrames frames;
    const RunSummary run = run_of(made, &frames);
    const FrameGroup& fluid = *group_of(frames.frames.back(), "fluid");
    const auto& found = field_of(fluid, "concentration")->values;
    // In spacings: how far particles have come across the flow, and how far from its place they show the marker.
    double moved = 0, off = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double y = fluid.position[3 * k + 1], count = static_cast<double>(fluid.size());
        moved += std::pow((y - made.particles.position[static_cast<std::size_t>(fluid.id[k])][1]) / dx, 2) / count;
        off += std::pow((y - height * found[k]) / dx, 2) / count;
    }
    EXPECT_GT(std::sqrt(moved), 0.05);
    EXPECT_LT(std::sqrt(off), 0.5 * std::sqrt(moved));
    EXPECT_LT(std::abs(run.species[0].residual()), 1e-14);
}

}  // namespace
}  // namespace dmp::tests::solver_species_tests
