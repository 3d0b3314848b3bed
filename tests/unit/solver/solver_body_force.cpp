// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Gravity acts on the mass of all that moves, a mean pressure gradient on the volume of liquid and of what it wets.
#include <cmath>

#include <gmock/gmock.h>
#include <unistd.h>

#include "solver/forcing/body_force.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/solver/walled_water.hpp"

namespace dmp::tests::solver_body_force_tests {
namespace {

constexpr double volume = 0.01;  ///< of a particle [m^3]

RunSummary run(const SceneAndParticles& made, FrameSink* sink = nullptr, int threads = 1) {
    RunOptions options;
    options.sink = sink;
    return Simulation(made.scene, made.particles, threads).run(options);
}

void set_gradient(Scene& scene, const std::string& x, const std::string& y = "0") {
    scene.flow.pressure_gradient = std::array{formula_of(x), formula_of(y), Expression()};
}

void set_gravity(Scene& scene, const std::string& x, const std::string& y) {
    scene.flow.acceleration = {formula_of(x), formula_of(y), Expression()};
}

/// Makes all nodes as heavy as this [kg].
void set_node_mass(SceneAndParticles& made, double mass) {
    for (std::size_t i = 0; i < made.particles.size(); ++i)
        if (made.particles.kind(i) == PartKind::elastic) made.particles.mass[i] = mass;
}

/// Two rods of two nodes of 40 kg, and nothing else; in the second one a node may be held.
SceneAndParticles rods_alone(bool held = false) {
    SceneAndParticles made = endless_water();
    made.particles = ParticleSet{};
    made.particles.spacing = 0.1;
    made.particles.box = {Vec::Zero(), Vec(0.8, 0.8, 0)};
    made.scene.parts.clear();
    made.scene.flow.periodic = {};
    made.scene.run.duration = made.scene.output.every = 0.2;
    add_flags(made);
    add_rod(made, Vec(0.3, 0.4, 0), 0);
    add_rod(made, Vec(0.6, 0.4, 0), 1);
    set_node_mass(made, 40);
    if (held) made.particles.fixed[3] = 1;
    return made;
}

/// Water without walls, with a rod in the place of two of its particles.
SceneAndParticles rod_in_water(double node_mass) {
    SceneAndParticles made = endless_water();
    ParticleSet& set = made.particles;
    const Vec position = set.position[27];
    for (const std::ptrdiff_t at : {35, 27}) {
        const auto erase = [at](auto& values) { values.erase(values.begin() + at); };
        erase(set.position);
        erase(set.volume);
        erase(set.mass);
        erase(set.part);
        erase(set.body);
        erase(set.fixed);
        erase(set.seated);
        erase(set.wall_normal);
        erase(set.wall_distance);
    }
    add_flags(made);
    add_rod(made, position, 0);
    set_node_mass(made, node_mass);
    made.scene.contact.range = 0.0;
    return made;
}

/// After the first step, of 0.1 ms.
Frame after_one_step(SceneAndParticles made, RunSummary* summary = nullptr) {
    made.scene.run.duration = made.scene.output.every = made.scene.output.measure_every = 1e-4;
    KeptFrames kept;
    const RunSummary ended = run(made, &kept);
    EXPECT_EQ(ended.steps, 1);
    EXPECT_LT(ended.momentum_residual, 1e-13);
    if (summary != nullptr) *summary = ended;
    return kept.frames.back();
}

float speed_along_x(const Frame& frame, const std::string& group, std::size_t particle) {
    return field_of(*group_of(frame, group), "velocity")->values[3 * particle];
}

TEST(Gravity, makes_solids_fall) {
    for (const SpringStepping stepping : {SpringStepping::implicit, SpringStepping::subcycled})
        for (const std::string everywhere : {"", " + 0 * x"}) {
            SceneAndParticles made = rods_alone();
            made.scene.numerics.spring_stepping = stepping;
            set_gravity(made.scene, "0.25" + everywhere, "-1.5" + everywhere);
            KeptFrames kept;
            const RunSummary summary = run(made, &kept);
            EXPECT_NEAR(summary.end.momentum[0], 160 * 0.25 * 0.2, 1e-12);
            EXPECT_NEAR(summary.end.momentum[1], -160 * 1.5 * 0.2, 1e-11);
            EXPECT_NEAR(summary.impulse_of_body_forces[1], -160 * 1.5 * 0.2, 1e-11);
            EXPECT_LT(summary.momentum_residual, 1e-13);
            // Bodies are half a step ahead, and begin with a whole one: g t (t + dt) / 2.
            const double ahead = 0.2 + 0.2 / static_cast<double>(summary.steps);
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_NEAR(field_of(*group_of(kept.frames.back(), "solid"), "displacement")->values[3 * k + 1],
                            -1.5 * 0.2 * ahead / 2, 1e-8);
        }
}

TEST(Gravity, of_a_held_node_goes_to_what_holds_it) {
    SceneAndParticles made = rods_alone(true);
    made.scene.run.duration = made.scene.output.every = 0.05;
    set_gravity(made.scene, "0", "-2");
    const RunSummary summary = run(made);
    EXPECT_NEAR(summary.impulse_of_body_forces[1], -160 * 2 * 0.05, 1e-11);
    EXPECT_GT(summary.impulse_of_fixed[1], 40 * 2 * 0.05 * 0.999) << "its own weight at least";
    EXPECT_LT(summary.momentum_residual, 1e-13);
}

enum class ElasticForm { solid, strip };

/// How far a rod in a tank of water at rest has risen after half a second [m]. A solid has a density and fills its
/// volume; the thickness of a strip is not known.
double rises_with(double node_mass, ElasticForm form = ElasticForm::solid) {
    WalledWater tank(8, 10, {"box"}, [](int, int) { return 1; });
    SceneAndParticles made{tank.scene, tank.particles};
    ParticleSet& set = made.particles;
    set_gravity(made.scene, "0", "-1");
    made.scene.flow.initial_pressure = formula_of("1000 * (1 - y)");
    made.scene.parts[0].viscosity = 10.0;
    made.scene.numerics.shifting = 0.0;
    made.scene.contact.range = 0.0;
    made.scene.run.duration = made.scene.output.every = 0.5;
    // Two particles of the water become the nodes.
    add_flags(made);
    for (Part& part : made.scene.parts)
        if (part.kind == PartKind::elastic && form == ElasticForm::solid)
            part.density = Value<double>(node_mass / 0.01, SourceLocation{"scene.toml", 1});
    const auto at = [&](double x, double y) {
        for (std::size_t i = 0; i < set.size(); ++i)
            if ((set.position[i] - Vec(x, y, 0)).norm() < 1e-9) return static_cast<int>(i);
        return -1;
    };
    const int low = at(0.35, 0.45), high = at(0.35, 0.55);
    for (const int node : {low, high}) {
        set.part[static_cast<std::size_t>(node)] = 2;
        set.body[static_cast<std::size_t>(node)] = 0;
        set.mass[static_cast<std::size_t>(node)] = node_mass;
    }
    set.bonds.push_back({low, high, 0.1, 1e4});
    KeptFrames kept;
    const RunSummary summary = run(made, &kept);
    EXPECT_LT(summary.momentum_residual, 1e-13);
    const FrameField& moved = *field_of(*group_of(kept.frames.back(), "solid"), "displacement");
    return 0.5 * (moved.values[1] + moved.values[4]);
}

TEST(Gravity, lets_solids_sink_that_are_denser_than_the_liquid_and_rise_that_are_lighter) {
    EXPECT_LT(rises_with(40), -0.01);
    EXPECT_GT(rises_with(2.5), 0.01);
    EXPECT_LT(rises_with(40, ElasticForm::strip), -0.01);
    EXPECT_NEAR(rises_with(2.5, ElasticForm::strip), 0, 1e-3) << "thin, with liquid in its nodes";
}

TEST(PressureGradient, drives_a_liquid_without_walls_at_its_force_over_the_density) {
    for (const ViscosityStepping stepping : {ViscosityStepping::explicitly, ViscosityStepping::implicitly}) {
        SceneAndParticles made = endless_water();
        made.scene.numerics.viscosity_stepping = stepping;
        set_gradient(made.scene, "-300", "400 * t");
        const RunSummary summary = run(made);
        EXPECT_NEAR(summary.end.momentum[0] / summary.end.mass, 0.3, 1e-12);
        EXPECT_NEAR(summary.end.momentum[1] / summary.end.mass, -0.2, 1e-12) << "a ramp is exact at mid-step";
        EXPECT_NEAR(summary.impulse_of_body_forces[0], 64 * volume * 300, 1e-9);
        EXPECT_LT(summary.momentum_residual, 1e-13);
        EXPECT_EQ(run(made, nullptr, 3).state_hash, summary.state_hash) << "on any number of threads";
    }
}

TEST(PressureGradient, accelerates_each_liquid_by_its_own_density) {
    SceneAndParticles made = endless_water();
    Part oil = made.scene.parts[0];
    oil.name = std::string("oil");
    oil.density = 500.0;
    made.scene.parts.push_back(oil);
    made.particles.parts.push_back({"oil", PartKind::fluid});
    for (std::size_t i = 32; i < 64; ++i) {
        made.particles.part[i] = 1;
        made.particles.mass[i] = 5;
    }
    set_gradient(made.scene, "-300");
    const Frame frame = after_one_step(made);
    const FrameGroup& fluid = *group_of(frame, "fluid");
    for (std::size_t k = 0; k < fluid.size(); ++k)
        EXPECT_NEAR(speed_along_x(frame, "fluid", k), (fluid.id[k] < 32 ? 0.3 : 0.6) * 1e-4, 1e-11) << k;
    const Plan plan = Simulation(made.scene, made.particles).plan();
    const auto limit = std::ranges::find(plan.limits, "body force", &StepLimit::model);
    ASSERT_NE(limit, plan.limits.end());
    EXPECT_NEAR(limit->dt, 0.25 * std::sqrt(0.5 * 0.3 / 0.6), 1e-12) << "by the lightest";
    const auto model = std::ranges::find(plan.models, "pressure gradient along x", &ModelUse::model);
    ASSERT_NE(model, plan.models.end());
    EXPECT_EQ(model->source, "-300, on the fluid and the elastic solids in it");
    EXPECT_EQ(model->reason, "flow.pressure_gradient");
}

TEST(PressureGradient, pushes_solids_in_the_liquid_by_their_volume) {
    for (const double mass : {10.0, 40.0}) {
        SceneAndParticles made = rod_in_water(mass);
        set_gradient(made.scene, "-300");
        RunSummary summary;
        const Frame frame = after_one_step(made, &summary);
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_NEAR(speed_along_x(frame, "solid", k), volume * 300 * 1e-4 / mass, 1e-11) << mass;
        EXPECT_NEAR(summary.impulse_of_body_forces[0], 64 * volume * 300 * 1e-4, 1e-12) << "as the liquid in its place";
    }
}

TEST(PressureGradient, and_gravity_add_up_on_held_solids_too) {
    SceneAndParticles made = rod_in_water(25);
    made.particles.fixed.back() = 1;
    made.scene.run.duration = made.scene.output.every = 0.1;
    set_gradient(made.scene, "-300 * cos(9 * t)", "100");
    set_gravity(made.scene, "0.2", "-0.4 * cos(2 * y)");
    const RunSummary summary = run(made);
    EXPECT_LT(summary.momentum_residual, 1e-13);
    EXPECT_LT(summary.impulse_of_fixed[0], -volume * 300 * 0.05);
}

/// A channel along x with a flag that is held at one wall.
SceneAndParticles channel_with_a_flag() {
    WalledWater water(12, 8, {"plates"}, [](int column, int) { return column >= 0 && column < 12 ? 1 : 0; });
    water.make_periodic(0);
    SceneAndParticles made{water.scene, water.particles};
    ParticleSet& set = made.particles;
    add_flags(made);
    std::vector<int> nodes;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (std::abs(set.position[i][0] - 0.55) < 1e-9 && set.position[i][1] > 0 && set.position[i][1] < 0.3)
            nodes.push_back(static_cast<int>(i));
    for (const int node : nodes) {
        set.part[static_cast<std::size_t>(node)] = 2;
        set.body[static_cast<std::size_t>(node)] = 0;
    }
    set.fixed[static_cast<std::size_t>(nodes.front())] = 1;
    for (std::size_t k = 1; k < nodes.size(); ++k) set.bonds.push_back({nodes[k - 1], nodes[k], 0.1, 1e4});
    made.scene.contact.range = 0.0;
    made.scene.run.duration = 0.4;
    made.scene.output.every = 0.2;
    return made;
}

TEST(PressureGradient, in_a_channel_is_nearly_the_acceleration_that_it_gives_the_liquid) {
    SceneAndParticles by_gradient = channel_with_a_flag(), by_acceleration = by_gradient;
    set_gradient(by_gradient.scene, "-500 * cos(t)");
    set_gravity(by_acceleration.scene, "0.5 * cos(t)", "0");
    const RunSummary one = run(by_gradient), other = run(by_acceleration);
    EXPECT_LT(one.momentum_residual, 1e-13);
    EXPECT_LT(one.impulse_of_fixed[0], 0) << "walls take it up by friction alone";
    EXPECT_NEAR(one.end.momentum[0], other.end.momentum[0], 2e-3 * other.end.momentum[0]);
    EXPECT_NE(one.state_hash, other.state_hash);
}

TEST(PressureGradient, goes_on_from_a_checkpoint_with_the_same_bits) {
    SceneAndParticles made = channel_with_a_flag();
    set_gradient(made.scene, "-500 * cos(t)");
    set_gravity(made.scene, "0", "-0.3");
    const auto folder = std::filesystem::temp_directory_path() / ("dmp_body_force_" + std::to_string(::getpid()));
    KeptFrames kept;
    const RunSummary parts = run_in_two_parts(made, folder), whole = run_of(made, &kept);
    EXPECT_EQ(parts.state_hash, whole.state_hash);
    EXPECT_EQ(parts.impulse_of_body_forces, whole.impulse_of_body_forces);
    EXPECT_LT(parts.momentum_residual, 1e-13);
    std::filesystem::remove_all(folder);
}

TEST(BodyForce, tells_what_continues_in_walls_and_what_builds_up_pressure) {
    SceneAndParticles made = endless_water("2 * t");
    set_gradient(made.scene, "-300 * t", "50");
    made.scene.flow.acceleration[1] = formula_of("x");
    const ParticleStore store(made.particles, std::vector<double>{1000});
    const BodyForce force(made.scene, made.particles, store);
    EXPECT_TRUE(force.has_gradient());
    EXPECT_EQ(force.force_density(2), (std::array<double, 3>{600, -50, 0}));
    EXPECT_EQ(force.uniform(2), (std::array<double, 3>{4, 0, 0}));
    EXPECT_EQ(force.hydrostatic(2), (std::array<double, 3>{0, 0, 0})) << "nothing builds up along a period";
    const auto in_walls = force.in_walls(2);
    EXPECT_NEAR(in_walls[0], 4.6, 1e-12);
    EXPECT_NEAR(in_walls[1], -0.05, 1e-12);
    EXPECT_NEAR(force.largest(2), std::hypot(4.6, 0.05), 1e-12);
}

}  // namespace
}  // namespace dmp::tests::solver_body_force_tests
