// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Scenes in which liquid turns solid and bonds break.
#include <cmath>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/clot_scenes.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_solidify_runs_tests {
namespace {

RunSummary run(const SceneAndParticles& made, FrameSink* sink = nullptr) {
    Simulation simulation(made.scene, made.particles, 1);
    RunOptions options;
    options.sink = sink;
    return simulation.run(options);
}

/// Water without walls that moves as a whole.
SceneAndParticles moving_water(const Vec& velocity, const std::string& acceleration = "0") {
    SceneAndParticles made = endless_water(acceleration);
    for (int axis = 0; axis < 2; ++axis) {
        const std::string text = std::to_string(velocity[axis]);
        made.scene.flow.initial_velocity.value[axis] = Expression(text, text);
    }
    made.scene.regions = {region_of("nidus", Vec(0.31, 0.31, 0), Vec(0.39, 0.39, 0))};
    Solidify clot = clot_of("water");
    clot.seed_region = std::string("nidus");
    clot.reach = 0.12;
    clot.interval = 0.02;
    clot.bond_stiffness = 1e4;
    made.scene.solidify = {clot};
    made.scene.run.duration = 0.05;
    made.scene.output.every = 0.05;
    made.scene.output.measure_every = 0.02;
    made.scene.measures = {size_of_clot()};
    return made;
}

TEST(Solidify, fills_a_diamond_in_liquid_at_rest_and_keeps_all_mass) {
    SceneAndParticles made = blood_channel();
    made.scene.regions = {middle_of(made)};
    Solidify clot = clot_of("blood");
    clot.seed_region = std::string("nidus");
    made.scene.solidify = {clot};
    made.scene.run.duration = 0.045;
    made.scene.output.every = 0.01;
    made.scene.output.measure_every = 0.01;
    made.scene.measures = {size_of_clot()};
    KeptFrames frames;
    const RunSummary summary = run(made, &frames);
    const double mass = 1000 * clot_spacing * clot_spacing;
    for (int n = 1; n <= 5; ++n) {
        const auto row = static_cast<std::size_t>(n - 1);
        EXPECT_EQ(measured(summary.measures, "clot_particles", row), 1 + 2 * n * (n + 1)) << n;
        EXPECT_NEAR(measured(summary.measures, "clot_mass", row), mass * (1 + 2 * n * (n + 1)), 1e-12 * mass);
        EXPECT_EQ(measured(summary.measures, "clot_pieces", row), 1);
        EXPECT_EQ(measured(summary.measures, "clot_largest", row), 1 + 2 * n * (n + 1));
        // A pair is tried from its solid side: as many bonds as the diamond has sides of cells across its rings.
        EXPECT_EQ(measured(summary.measures, "clot_bonds_made", row), 4 * n * n);
        EXPECT_EQ(bonds_of(frames.frames.at(row)).size(), static_cast<std::size_t>(4 * n * n));
        EXPECT_EQ(group_of(frames.frames[row], "solid")->size(), static_cast<std::size_t>(1 + 2 * n * (n + 1)));
    }
    EXPECT_NEAR(summary.end.mass, summary.start.mass, 1e-14 * summary.start.mass);
    EXPECT_EQ(summary.particles.at("elastic"), 61U);
    EXPECT_EQ(summary.particles.at("fluid"), 24U * 16 - 61);
    ASSERT_EQ(summary.aggregates.size(), 1U);
    EXPECT_EQ(summary.aggregates[0].bonds_made, 100);
    EXPECT_EQ(summary.lost, 0U);
}

TEST(Solidify, ends_before_its_last_time) {
    SceneAndParticles made = blood_channel();
    made.scene.regions = {middle_of(made)};
    Solidify clot = clot_of("blood");
    clot.seed_region = std::string("nidus");
    clot.until = 0.02;  // events at 0 and 0.01 s
    made.scene.solidify = {clot};
    made.scene.run.duration = 0.045;
    made.scene.output.measure_every = 0.01;
    made.scene.measures = {size_of_clot()};
    const RunSummary summary = run(made);
    for (std::size_t row = 1; row < summary.measures.rows.size(); ++row)
        EXPECT_EQ(measured(summary.measures, "clot_particles", row), 13) << row;
}

TEST(Solidify, in_space_fills_an_octahedron) {
    SceneAndParticles made = endless_water();
    ParticleSet& set = made.particles;
    const ParticleSet layer = set;
    set.position.clear();
    made.scene.dimension = set.dimension = 3;
    set.box.high[2] = 0.8;
    set.periodic[2] = true;
    made.scene.flow.periodic[2] = true;
    for (int level = 0; level < 8; ++level)
        for (const Vec& position : layer.position)
            set.position.emplace_back(position[0], position[1], 0.1 * (level + 0.5));
    const std::size_t count = set.position.size();
    set.volume.assign(count, 1e-3);
    set.mass.assign(count, 1);
    for (auto* numbers : {&set.part, &set.body}) numbers->resize(count, numbers->front());
    for (auto* flags : {&set.fixed, &set.seated}) flags->resize(count, 0);
    set.wall_normal.resize(count, Vec::Zero());
    set.wall_distance.resize(count, 0);
    made.scene.regions = {region_of("nidus", Vec(0.41, 0.41, 0.41), Vec(0.49, 0.49, 0.49))};
    Solidify clot = clot_of("water");
    clot.seed_region = std::string("nidus");
    clot.reach = 0.12;
    made.scene.solidify = {clot};
    made.scene.run.duration = made.scene.output.every = 0.015;
    const RunSummary summary = run(made);
    EXPECT_EQ(summary.aggregates.at(0).particles, 1 + 6 + 18);
    EXPECT_EQ(summary.aggregates.at(0).pieces, 1);
    EXPECT_NEAR(summary.end.mass, summary.start.mass, 1e-14 * summary.start.mass);
}

TEST(Solidify, of_liquid_that_moves_as_a_whole_changes_no_velocity_and_no_momentum) {
    const Vec velocity(0.4, -0.1, 0);
    KeptFrames frames;
    SceneAndParticles made = moving_water(velocity);
    made.scene.solidify[0].from = 0.02;
    made.scene.run.duration = made.scene.output.every = 0.06;  // in equal steps: bodies are half a one ahead
    const RunSummary summary = run(made, &frames);
    EXPECT_EQ(summary.aggregates.at(0).particles, 25);
    for (int axis = 0; axis < 2; ++axis)
        EXPECT_NEAR(summary.end.momentum[axis], summary.start.momentum[axis], 1e-13 * summary.start.momentum[0]);
    EXPECT_NEAR(summary.end.mass, summary.start.mass, 1e-14 * summary.start.mass);
    for (const std::string& kind : {std::string("fluid"), std::string("solid")}) {
        const FrameGroup& group = *group_of(frames.frames.back(), kind);
        const FrameField& shown = *field_of(group, "velocity");
        for (std::size_t k = 0; k < group.size(); ++k)
            for (int axis = 0; axis < 2; ++axis)
                EXPECT_NEAR(shown.values[3 * k + axis], velocity[axis], 1e-6) << kind << k;
    }
    const FrameField& strain = group_of(frames.frames.back(), "solid")->bond_fields.front();
    ASSERT_EQ(strain.name, "strain");
    for (const float value : strain.values) EXPECT_NEAR(value, 0, 1e-6);
}

TEST(Solidify, what_turned_solid_goes_on_to_feel_the_body_acceleration) {
    for (const std::string acceleration : {"2", "x < 100 ? 2 : 1"}) {
        KeptFrames frames;
        const RunSummary summary = run(moving_water(Vec(0.1, 0, 0), acceleration), &frames);
        const FrameGroup& solid = *group_of(frames.frames.back(), "solid");
        EXPECT_EQ(solid.size(), 25U);
        for (std::size_t k = 0; k < solid.size(); ++k)
            EXPECT_NEAR(field_of(solid, "velocity")->values[3 * k], 0.1 + 2 * 0.05, 2e-3);
        EXPECT_LT(summary.momentum_residual, 1e-12) << acceleration;
        EXPECT_NEAR(summary.impulse_of_body_forces[0], 640 * 2 * 0.05, 1e-9);
    }
}

TEST(Solidify, what_turned_solid_goes_on_to_feel_the_pressure_gradient) {
    SceneAndParticles made = moving_water(Vec(0.1, 0, 0), "0.5");
    made.scene.flow.pressure_gradient.value[0] = Expression("-1500", "-1500");
    KeptFrames frames;
    const RunSummary summary = run(made, &frames);
    const FrameGroup& solid = *group_of(frames.frames.back(), "solid");
    EXPECT_EQ(solid.size(), 25U);
    for (std::size_t k = 0; k < solid.size(); ++k)
        EXPECT_NEAR(field_of(solid, "velocity")->values[3 * k], 0.1 + 2 * 0.05, 2e-3);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_NEAR(summary.impulse_of_body_forces[0], 640 * 2 * 0.05, 1e-4) << "each particle once";
}

TEST(Solidify, from_a_wall_holds_on_to_it_and_the_momentum_adds_up) {
    SceneAndParticles made = blood_channel(24, "0.5");
    Solidify clot = clot_of("blood");
    clot.seed_part = std::string("wall");
    clot.rule = SolidifyRule::per_candidate;
    clot.probability = 0.5;
    clot.bond_to = BondTo::neighbours;
    clot.bond_stiffness = 2e3;
    clot.bond_damping = 0.5;
    clot.interval = 0.004;
    clot.reach = 1.5 * clot_spacing;
    made.scene.regions = {region_of("low", Vec(0, 0, 0), Vec(12 * clot_spacing, 3 * clot_spacing, 0))};
    clot.region = std::string("low");
    made.scene.solidify = {clot};
    made.scene.run.duration = 0.1;
    made.scene.output.every = 0.1;
    KeptFrames frames;
    const RunSummary summary = run(made, &frames);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_NEAR(summary.end.mass, summary.start.mass, 1e-14 * summary.start.mass);
    EXPECT_EQ(summary.lost, 0U);
    const Aggregate& aggregate = summary.aggregates.at(0);
    EXPECT_GT(aggregate.particles, 20);
    const FrameGroup& solid = *group_of(frames.frames.back(), "solid");
    ASSERT_EQ(static_cast<std::int64_t>(solid.size()), aggregate.particles);
    EXPECT_LT(static_cast<std::int64_t>(solid.bonds()), aggregate.bonds_made) << "those to the wall are not shown";
    EXPECT_GT(static_cast<std::int64_t>(solid.bonds()), aggregate.particles);
    double slowest = 1, fastest = 0;
    for (std::size_t k = 0; k < solid.size(); ++k) {
        EXPECT_LT(solid.position[3 * k + 1], 3.2 * clot_spacing);
        fastest = std::max<double>(fastest, std::abs(field_of(solid, "velocity")->values[3 * k]));
    }
    const FrameGroup& fluid = *group_of(frames.frames.back(), "fluid");
    for (std::size_t k = 0; k < fluid.size(); ++k)
        if (std::abs(fluid.position[3 * k + 1] - 8 * clot_spacing) < clot_spacing)
            slowest = std::min<double>(slowest, field_of(fluid, "velocity")->values[3 * k]);
    EXPECT_LT(fastest, 0.1 * slowest);
}

TEST(Solidify, joins_drawn_bodies_and_stiff_bonds_are_stable_with_either_stepper) {
    for (const auto stepping : {SpringStepping::implicit, SpringStepping::subcycled}) {
        SceneAndParticles made = endless_water();
        ParticleSet& set = made.particles;
        add_flags(made);
        // Two columns of water become rods: the second and the seventh.
        for (const auto& [index, body] : {std::pair{17, 0}, {22, 1}})
            for (const int row : {0, 1}) {
                const auto i = static_cast<std::size_t>(index + 8 * row);
                set.part[i] = 1;
                set.body[i] = body;
            }
        set.bonds = {{17, 25, 0.1, 1e3}, {22, 30, 0.1, 1e3}};
        made.scene.numerics.spring_stepping = stepping;
        made.scene.flow.initial_velocity.value[0] = Expression("0.2", "0.2");
        made.scene.flow.initial_velocity.value[1] = Expression("0.1*sin(2*pi*x/0.8)", "0.1*sin(2*pi*x/0.8)");
        Solidify clot = clot_of("water");
        clot.seed_part = std::string("flags");
        clot.reach = 0.14;
        clot.interval = 0.004;
        clot.bond_stiffness = 1e8;  // far stiffer than the fluid's step could stand
        clot.bond_to = BondTo::neighbours;
        made.scene.regions = {region_of("between", Vec(0, 0.2, 0), Vec(0.8, 0.4, 0))};
        clot.region = std::string("between");
        made.scene.solidify = {clot};
        made.scene.run.duration = 0.02;
        made.scene.output.every = 0.02;
        KeptFrames frames;
        const RunSummary summary = run(made, &frames);
        EXPECT_EQ(summary.aggregates.at(1).pieces, 1) << "both rods are in one body";
        EXPECT_EQ(summary.aggregates.at(0).pieces, 1);
        EXPECT_GE(summary.aggregates.at(1).particles, 6);
        EXPECT_LT(summary.momentum_residual, 1e-9);
        const FrameGroup& solid = *group_of(frames.frames.back(), "solid");
        for (const float value : solid.bond_fields.front().values) EXPECT_LT(std::abs(value), 0.02);
    }
}

TEST(Solidify, keeps_to_its_times_its_liquid_and_the_seeds_that_may_act) {
    SceneAndParticles made = moving_water(Vec::Zero());
    Solidify& clot = made.scene.solidify[0];
    clot.from = 0.01;
    clot.active = SeedActivity::one_in;
    clot.one_in = 3;
    clot.spreads = false;
    clot.most_bonds = 3;
    clot.rule = SolidifyRule::mutually_closest;
    made.scene.run.duration = 0.2;
    const RunSummary summary = run(made);
    // Events at 0.01 + k 0.02 s, k = 0 .. 9; the seed acts at k = 0, 3, 6, and has then all bonds that it may have.
    std::vector<double> sizes;
    for (std::size_t row = 0; row < summary.measures.rows.size(); ++row)
        sizes.push_back(measured(summary.measures, "clot_particles", row));
    EXPECT_THAT(sizes, ::testing::ElementsAre(0, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4));
}

TEST(Solidify, starts_where_stress_or_residence_say) {
    // v = 0.1 sin(2 pi x / 0.8): the shear is largest at x = 0 and 0.4, 0 between.
    SceneAndParticles made = endless_water();
    made.scene.flow.initial_velocity.value[1] = Expression("0.1*sin(2*pi*x/0.8)", "0.1*sin(2*pi*x/0.8)");
    Solidify clot = clot_of("water");
    clot.reach = 0.05;  // seeds only
    clot.seed_stress_above = 0.6 * 0.1 * 2 * M_PI / 0.8;
    made.scene.solidify = {clot};
    made.scene.run.duration = 0.001;
    made.scene.output.every = 0.001;
    KeptFrames frames;
    run(made, &frames);
    const FrameGroup& solid = *group_of(frames.frames.front(), "solid");
    EXPECT_EQ(solid.size(), 4 * 8U) << "the columns beside x = 0 and 0.4";
    for (std::size_t k = 0; k < solid.size(); ++k)
        EXPECT_GT(std::abs(std::cos(2 * M_PI * solid.position[3 * k] / 0.8)), 0.6);

    SceneAndParticles waiting = moving_water(Vec(1, 0, 0));
    waiting.scene.regions = {region_of("strip", Vec(0.2, 0, 0), Vec(0.4, 0.8, 0))};
    Solidify& late = waiting.scene.solidify[0];
    late.seed_region = std::string("strip");
    late.seed_residence_above = 0.075;
    late.reach = 0.05;
    waiting.scene.run.duration = 0.2;
    const RunSummary summary = run(waiting);
    EXPECT_EQ(measured(summary.measures, "clot_particles", 3), 0) << "at 0.06 s";
    EXPECT_EQ(measured(summary.measures, "clot_particles", 4), 8) << "at 0.08 s: the column that was 0.15 s long in it";
}

TEST(Breaking, tears_a_stretched_rod_and_its_pieces_part) {
    SceneAndParticles made = endless_water();
    add_flags(made);
    ParticleSet& set = made.particles;
    for (const int i : {18, 26, 34}) {
        set.part[i] = 1;
        set.body[i] = 0;
    }
    set.bonds = {{18, 26, 0.08, 1e3}, {26, 34, 0.0999, 1e3}};
    Breaking tear;
    tear.name = std::string("tear");
    tear.part = std::string("flags");
    tear.strain_above = 0.2;
    made.scene.breaking = {tear};
    made.scene.run.duration = 0.01;
    made.scene.output.every = 0.01;
    KeptFrames frames;
    const RunSummary summary = run(made, &frames);
    EXPECT_EQ(bonds_of(frames.frames.front()), (std::set<std::pair<std::int64_t, std::int64_t>>{{26, 34}}));
    ASSERT_EQ(summary.aggregates.size(), 1U);
    EXPECT_EQ(summary.aggregates[0].name, "flags");
    EXPECT_EQ(summary.aggregates[0].pieces, 2);
    EXPECT_EQ(summary.aggregates[0].bonds_broken, 1);
    EXPECT_EQ(summary.aggregates[0].bonds_made, 0);
    EXPECT_LT(summary.momentum_residual, 1e-13);
}

TEST(Solidify, refuses_what_the_particles_do_not_have) {
    const auto problem = [](const std::function<void(SceneAndParticles&)>& change) {
        SceneAndParticles made = moving_water(Vec::Zero());
        change(made);
        return text_thrown<InputError>([&] { Simulation(made.scene, made.particles, 1); });
    };
    EXPECT_EQ(problem([](SceneAndParticles& made) {
                  made.scene.regions[0].from = Vec(0.31, 0.31, 0);
                  made.scene.regions[0].to = Vec(0.34, 0.34, 0);
                  made.scene.solidify[0].seed_region.location = {"scene.toml", 7, 3};
              }),
              "scene.toml:7:3: seed_region of solidify 'clot': there is no particle of 'water' in the region 'nidus'\n"
              "  move the region into the liquid, or make it as large as a few spacings");
    EXPECT_EQ(problem([](SceneAndParticles& made) {
                  made.scene.solidify[0].reach = {0.4, {"scene.toml", 8, 9}};
              }),
              "scene.toml:8:9: reach of solidify 'clot' is half the period along x or more: a seed would find the same "
              "liquid on both sides\n"
              "  lower it; neighbours are about a spacing away");
}

}  // namespace
}  // namespace dmp::tests::solver_solidify_runs_tests
