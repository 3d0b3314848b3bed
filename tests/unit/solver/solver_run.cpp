// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "small_scenes.hpp"
#include "solver/run/setup.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_run_tests {
namespace {

using testing::Contains;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> models(const Plan& plan) {
    std::vector<std::string> names;
    for (const ModelUse& use : plan.models) names.push_back(use.model);
    return names;
}

std::vector<std::string> limits(const Plan& plan) {
    std::vector<std::string> names;
    for (const StepLimit& limit : plan.limits) names.push_back(limit.model);
    return names;
}

double limit_of(const Plan& plan, const std::string& model) {
    for (const StepLimit& limit : plan.limits)
        if (limit.model == model) return limit.dt;
    return std::numeric_limits<double>::quiet_NaN();
}

RunOptions options(FrameSink* sink, double until = 0, const std::atomic<bool>* stop = nullptr) {
    RunOptions chosen;
    chosen.sink = sink;
    chosen.until = until;
    chosen.stop = stop;
    return chosen;
}

RunSummary run(const SceneAndParticles& made, const RunOptions& chosen = {}) {
    Simulation simulation(made.scene, made.particles, 1);
    return simulation.run(chosen);
}

TEST(Frames, come_at_exactly_the_times_asked_for) {
    SceneAndParticles made = endless_water("0.5");
    made.scene.output.every = 0.1;
    made.scene.output.measure_every = 0.03;  // its times must not shift those of the frames
    KeptFrames kept;
    const RunSummary summary = run(made, options(&kept));
    ASSERT_EQ(kept.frames.size(), 11U);
    for (std::size_t k = 0; k < kept.frames.size(); ++k)
        EXPECT_DOUBLE_EQ(kept.frames[k].time, static_cast<double>(k) * 0.1);
    EXPECT_EQ(summary.simulated_s, 1.0);
    EXPECT_EQ(kept.frames.front().step, 0);
    EXPECT_EQ(kept.frames.back().step, summary.steps);
    EXPECT_FALSE(summary.interrupted);
}

TEST(Frames, end_where_the_run_is_told_to_end) {
    SceneAndParticles made = endless_water("0.5");
    KeptFrames kept;
    const RunSummary summary = run(made, options(&kept, 0.6));
    EXPECT_THAT(kept.times(), ElementsAre(0, 0.25, 0.5, 0.6));
    EXPECT_EQ(summary.simulated_s, 0.6);
}

TEST(Frames, hold_the_fields_the_scene_asks_for) {
    SceneAndParticles made = endless_water("0.5");
    KeptFrames kept;
    run(made, options(&kept));
    const FrameGroup* fluid = group_of(kept.frames.back(), "fluid");
    ASSERT_NE(fluid, nullptr);
    ASSERT_EQ(fluid->size(), 64U);
    std::vector<std::string> names;
    for (const FrameField& field : fluid->fields) {
        names.push_back(field.name + " [" + field.unit + "]");
        EXPECT_EQ(field.values.size(), 64U * static_cast<std::size_t>(field.components)) << field.name;
    }
    EXPECT_THAT(names, ElementsAre("velocity [m/s]", "pressure [Pa]", "density [kg/m^3]"));
    const FrameField& velocity = *field_of(*fluid, "velocity");
    for (std::size_t k = 0; k < fluid->size(); ++k) {
        EXPECT_EQ(fluid->id[k], static_cast<std::int64_t>(k));
        EXPECT_FLOAT_EQ(velocity.values[3 * k], 0.5F);
        EXPECT_EQ(velocity.values[3 * k + 2], 0);
    }
    EXPECT_EQ(kept.frames.back().parts, std::vector<std::string>{"water"});
    EXPECT_EQ(kept.frames.back().spacing, 0.1);
}

TEST(Frames, show_walls_once_and_springs_with_their_bonds) {
    const SceneAndParticles made = case_of("vein_valve", {"particles.spacing=0.4 mm", "output.every=1 ms"});
    KeptFrames kept;
    run(made, options(&kept, 0.002));
    ASSERT_EQ(kept.frames.size(), 3U);
    EXPECT_NE(group_of(kept.frames[0], "walls"), nullptr);
    EXPECT_EQ(group_of(kept.frames[1], "walls"), nullptr);
    const FrameGroup* solid = group_of(kept.frames[2], "solid");
    ASSERT_NE(solid, nullptr);
    EXPECT_EQ(solid->bonds(), made.particles.bonds.size());
    ASSERT_NE(field_of(*solid, "velocity"), nullptr);
    ASSERT_NE(field_of(*solid, "displacement"), nullptr);
    ASSERT_EQ(solid->bond_fields.size(), 2U);
    EXPECT_EQ(solid->bond_fields[0].name, "strain");
    EXPECT_EQ(solid->bond_fields[1].name, "force");
    for (std::size_t b = 0; b < solid->bonds(); ++b)
        for (int end = 0; end < 2; ++end) {
            const int index = solid->bond_ends[2 * b + end];
            ASSERT_GE(index, 0);
            EXPECT_EQ(solid->id[index], end == 0 ? made.particles.bonds[b].a : made.particles.bonds[b].b);
        }
    // Force and strain belong together: 2 k_b r0 strain.
    for (std::size_t b = 0; b < solid->bonds(); ++b) {
        const Bond& bond = made.particles.bonds[b];
        const double force = 2 * bond.stiffness * bond.rest_length * solid->bond_fields[0].values[b];
        EXPECT_NEAR(solid->bond_fields[1].values[b], force, 1e-6 + 1e-5 * std::abs(force));
    }
}

TEST(Run, uniform_acceleration_is_followed_exactly) {
    SceneAndParticles made = endless_water("0.3 * t");
    const RunSummary summary = run(made);
    // The kicks take g at mid-step, which is exact for a linear g: momentum = m 0.3 t^2 / 2.
    EXPECT_NEAR(summary.end.momentum[0], 640 * 0.15, 1e-9);
    EXPECT_NEAR(summary.impulse_of_body_forces[0], 640 * 0.15, 1e-9);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_EQ(summary.end.mass, summary.start.mass);
    EXPECT_NEAR(summary.density_low, 1000, 1e-9);
    EXPECT_NEAR(summary.density_high, 1000, 1e-9);
    EXPECT_EQ(summary.particles.at("fluid"), 64U);
    EXPECT_GT(summary.particle_steps_per_s, 0);
    EXPECT_THAT(summary.seconds_by_stage, Contains(testing::Key("forces")));
}

TEST(Run, acceleration_that_depends_on_place_acts_where_particles_are) {
    SceneAndParticles made = endless_water("0.01 * cos(2 * 3.14159265358979 * y / 0.8)");
    const RunSummary summary = run(made, options(nullptr, 0.25));
    EXPECT_NEAR(summary.end.momentum[0], 0, 1e-9);
    EXPECT_LT(std::abs(summary.impulse_of_body_forces[0]), 1e-9);
}

TEST(Run, spring_bodies_without_any_fluid_move_on_their_own) {
    SceneAndParticles made = endless_water();
    made.scene.parts.clear();
    made.particles = {};
    made.particles.spacing = 0.1;
    made.particles.box = {Vec(-1, -1, 0), Vec(1, 1, 0)};
    add_flags(made);
    add_rod(made, Vec(0, 0, 0), 0);
    made.particles.bonds[0].rest_length = 0.11;  // it is pressed together
    KeptFrames kept;
    const RunSummary summary = run(made, options(&kept));
    EXPECT_EQ(summary.simulated_s, 1.0);
    EXPECT_EQ(summary.start.mass, 20);
    EXPECT_NEAR(summary.end.momentum[1], 0, 1e-12);
    const FrameGroup* solid = group_of(kept.frames.back(), "solid");
    ASSERT_NE(solid, nullptr);
    for (const float x : solid->position) EXPECT_TRUE(std::isfinite(x));
    EXPECT_NE(solid->position[1], 0);
}

TEST(Run, stops_when_told_to_and_leaves_a_last_frame) {
    const SceneAndParticles made = endless_water("0.5");
    KeptFrames kept;
    std::atomic<bool> stop = false;
    class StopAfterTwo : public FrameSink {
      public:
        StopAfterTwo(KeptFrames& k, std::atomic<bool>& s) : kept_(k), stop_(s) {}
        void write(const Frame& frame) override {
            kept_.write(frame);
            if (kept_.frames.size() == 2) stop_ = true;
        }

      private:
        KeptFrames& kept_;
        std::atomic<bool>& stop_;
    } sink(kept, stop);
    const RunSummary summary = run(made, options(&sink, 0, &stop));
    EXPECT_TRUE(summary.interrupted);
    EXPECT_GE(summary.simulated_s, 0.25);
    EXPECT_LT(summary.simulated_s, 0.5);
    EXPECT_EQ(kept.frames.back().time, summary.simulated_s);
    EXPECT_EQ(kept.frames.back().step, summary.steps);
}

TEST(Run, an_interrupted_run_writes_no_time_twice) {
    const SceneAndParticles made = endless_water("0.5");
    KeptFrames kept;
    const std::atomic<bool> stop = true;
    const RunSummary summary = run(made, options(&kept, 0, &stop));
    EXPECT_TRUE(summary.interrupted);
    EXPECT_EQ(summary.steps, 0);
    EXPECT_THAT(kept.times(), ElementsAre(0));
}

/// What the divergence of this scene says; a last frame must have been written.
std::string divergence_of(const SceneAndParticles& made) {
    KeptFrames kept;
    Simulation simulation(made.scene, made.particles, 1);
    try {
        simulation.run(options(&kept));
    } catch (const DivergenceError& error) {
        EXPECT_EQ(kept.frames.size(), 2U);
        EXPECT_GT(kept.frames.back().time, 0);
        EXPECT_FALSE(error.what_to_do().empty());
        return error.problem();
    }
    return "no error";
}

TEST(StabilityMonitor, names_the_particle_that_is_faster_than_sound) {
    SceneAndParticles made = endless_water("1000");
    made.scene.flow.largest_speed = 0.01;
    made.scene.output.every = 1.0;
    const std::string problem = divergence_of(made);
    EXPECT_THAT(problem, ContainsRegex("diverged at t = [0-9.]+ s, step [0-9]+: particle [0-9]+ of 'water' at \\("));
    EXPECT_THAT(problem, HasSubstr("is faster than sound: speed "));
    EXPECT_THAT(problem, HasSubstr("sound speed 0.1 m/s"));
}

TEST(StabilityMonitor, names_a_particle_whose_state_is_no_number) {
    SceneAndParticles made = endless_water("sqrt(0.01 - t)");
    made.scene.output.every = 1.0;
    EXPECT_THAT(divergence_of(made), ContainsRegex("particle [0-9]+ of 'water' at \\(.*is not finite"));
}

TEST(StabilityMonitor, survives_that_only_some_particles_are_no_numbers) {
    // Half of the fluid moves on properly, so the neighbour list is made again with the others in it.
    SceneAndParticles made = endless_water("t < 0.3 ? 0.9 : sqrt(y - 0.4)");
    made.scene.output.every = 1.0;
    EXPECT_THAT(divergence_of(made), ContainsRegex("particle [0-9]+ of 'water' at \\(.*is not finite"));
}

TEST(StabilityMonitor, survives_a_burst) {
    // One particle is thrown out at once: far away, other lists, but a message at the end.
    SceneAndParticles made = endless_water("x < 0.06 ? 1e12 : 0");
    made.particles.periodic = {false, false, false};
    made.scene.output.every = 1.0;
    EXPECT_THAT(divergence_of(made), ContainsRegex("particle [0-9]+ of 'water' at \\("));
}

TEST(StabilityMonitor, names_a_particle_that_has_left_the_domain) {
    SceneAndParticles made = endless_water("0.5");
    made.particles.periodic = {false, false, false};
    made.scene.flow.largest_speed = 2.0;
    made.scene.run.duration = 4.0;
    made.scene.output.every = 8.0;
    EXPECT_THAT(divergence_of(made), HasSubstr("has left the domain"));
}

TEST(StabilityMonitor, spring_body_that_cannot_follow_its_load_is_a_divergence_too) {
    // A node that all but lies on a fluid particle: the repulsion between them is beyond all measure.
    SceneAndParticles made = endless_water("0.5");
    add_flags(made);
    add_rod(made, made.particles.position[27] + Vec(2e-3 * made.particles.spacing, 0, 0), 0);
    made.scene.run.duration = 0.02;
    KeptFrames kept;
    Simulation simulation(made.scene, made.particles, 1);
    try {
        simulation.run(options(&kept));
        FAIL() << "no error";
    } catch (const DivergenceError& error) {
        EXPECT_EQ(kept.frames.size(), 2U);
        EXPECT_THAT(error.problem(), HasSubstr("the simulation diverged at t = "));
    }
}

TEST(Plan, of_the_vein_valve_names_models_with_reasons) {
    const SceneAndParticles made = case_of("vein_valve", {"particles.spacing=0.4 mm"});
    const Simulation simulation(made.scene, made.particles, 1);
    const Plan plan = simulation.plan();
    EXPECT_THAT(models(plan),
                ElementsAre("equation of state", "continuity", "pressure force", "velocity gradient", "pressure level",
                            "viscous force", "density diffusion", "particle shifting", "pressure gradient along x",
                            "extrapolated walls", "bonds with dashpots", "hinges", "implicit springs",
                            "short-range repulsion", "contact of surfaces"));
    for (const ModelUse& use : plan.models) {
        EXPECT_FALSE(use.source.empty()) << use.model;
        EXPECT_FALSE(use.reason.empty()) << use.model;
    }
    EXPECT_THAT(plan.models[5].reason, ContainsRegex("viscosity at .*scene.toml:[0-9]+:[0-9]+"));
    EXPECT_EQ(plan.models[6].reason, "numerics.density_diffusion (default)");
    EXPECT_THAT(plan.models[10].reason, ContainsRegex("part 'leaflets' at .*scene.toml:[0-9]+:[0-9]+"));
    EXPECT_EQ(plan.particles.at("fluid"), made.particles.count(PartKind::fluid));
    EXPECT_EQ(plan.particles.at("rigid"), made.particles.count(PartKind::rigid));
    EXPECT_EQ(plan.particles.at("elastic"), made.particles.count(PartKind::elastic));
}

TEST(Plan, limits_the_step_and_says_what_rules) {
    const SceneAndParticles made =
        case_of("vein_valve", {"particles.spacing=0.4 mm", "flow.largest_speed=0.22 m/s", "numerics.sound_speed=auto",
                               "run.duration=4 s", "flow.pressure_gradient=[\"-158.4 Pa/m * sin(2*pi*t / 4 s)\", 0]"});
    const Simulation simulation(made.scene, made.particles, 1);
    const Plan plan = simulation.plan();
    EXPECT_DOUBLE_EQ(plan.sound_speed, 2.2);
    EXPECT_DOUBLE_EQ(plan.largest_speed, 0.22);
    EXPECT_THAT(limits(plan),
                testing::IsSupersetOf({"sound", "viscosity", "body force", "contact", "elastic (leaflets)"}));
    double shortest = 1e300;
    std::string ruling;
    for (const StepLimit& limit : plan.limits)
        if (limit.model.rfind("elastic", 0) != 0 && limit.dt < shortest) {
            shortest = limit.dt;
            ruling = limit.model;
        }
    EXPECT_EQ(plan.ruling_limit, ruling);
    EXPECT_EQ(plan.dt, shortest);
    EXPECT_EQ(plan.steps, 400 * static_cast<long>(std::ceil(0.01 / plan.dt))) << "none goes beyond a row of measures";
    // The drive's amplitude, not its value at the start, sets the body force's limit.
    EXPECT_NEAR(limit_of(plan, "body force") / (0.25 * std::sqrt(1.2e-3 / 2 / 0.15)), 1, 1e-4);
}

TEST(Plan, of_poiseuille_is_ruled_by_viscosity) {
    const SceneAndParticles made = case_of("verification/poiseuille", {});
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    EXPECT_EQ(plan.ruling_limit, "viscosity");
    EXPECT_EQ(plan.spring_substeps, 0);
    EXPECT_THAT(models(plan), testing::Not(Contains("hinges")));
}

TEST(Plan, counts_the_spring_steps_in_one_fluid_step) {
    const auto substeps = [](const std::string& stepping) {
        const SceneAndParticles made =
            case_of("vein_valve", {"particles.spacing=0.4 mm", "numerics.spring_stepping=" + stepping});
        return Simulation(made.scene, made.particles, 1).plan();
    };
    EXPECT_EQ(substeps("implicit").spring_substeps, 1);
    const Plan plan = substeps("subcycled");
    EXPECT_EQ(plan.spring_substeps,
              static_cast<int>(std::ceil(plan.dt / (0.5 * limit_of(plan, "elastic (leaflets)")))));
}

TEST(Plan, models_that_are_switched_off_do_not_run_and_have_no_fields) {
    SceneAndParticles made = endless_water("0.5");
    use_plain_scheme(made.scene);
    const Plan with = Simulation(made.scene, made.particles, 1).plan();
    made.scene.numerics.shifting = 0.0;
    made.scene.numerics.density_diffusion = 0.0;
    made.scene.flow.acceleration[0] = Expression();
    const Plan without = Simulation(made.scene, made.particles, 1).plan();
    EXPECT_THAT(models(without), ElementsAre("equation of state", "continuity", "pressure force", "viscous force"));
    const auto shifting = std::ranges::find(with.models, "particle shifting", &ModelUse::model);
    ASSERT_NE(shifting, with.models.end());
    EXPECT_THAT(shifting->fields, ElementsAre("fluid: shift, 16 bytes"));
    EXPECT_EQ(shifting->bytes, 16U);
    EXPECT_THAT(with.common_fields, Contains("fluid: position, 16 bytes"));
    EXPECT_THAT(with.common_fields, testing::Not(Contains(HasSubstr("shift"))));
    std::size_t fields = with.common_fields.size();
    for (const ModelUse& use : with.models) fields += use.fields.size();
    EXPECT_EQ(fields, with.fields.size()) << "each field is told once";
    EXPECT_THAT(with.fields, Contains("fluid: shift, 16 bytes"));
    EXPECT_THAT(without.fields, testing::Not(Contains(HasSubstr("shift"))));
    // An array has a vector's width of room behind its end: 80 numbers for 64 particles.
    EXPECT_EQ(with.bytes_per_particle, without.bytes_per_particle + 20);
    EXPECT_THAT(limits(with), Contains("shifting"));
    EXPECT_THAT(limits(without), testing::Not(Contains("shifting")));
}

TEST(Plan, lists_the_fields_of_each_kind_which_exist_only_where_they_are_needed) {
    const SceneAndParticles made = case_of("vein_valve", {"particles.spacing=0.4 mm"});
    const auto fields = Simulation(made.scene, made.particles, 1).plan().fields;
    const auto kinds_with = [&](const std::string& field) {
        std::vector<std::string> kinds;
        for (const std::string& listed : fields)
            if (listed.ends_with(": " + field)) kinds.push_back(listed.substr(0, listed.find(':')));
        return kinds;
    };
    for (const char* everywhere : {"position, 16 bytes", "velocity, 16 bytes", "mass, 8 bytes", "force, 16 bytes"})
        EXPECT_THAT(kinds_with(everywhere), ElementsAre("fluid", "rigid", "elastic")) << everywhere;
    for (const char* of_fluid : {"density, 8 bytes", "density_rate, 8 bytes", "viscosity, 8 bytes", "shift, 16 bytes"})
        EXPECT_THAT(kinds_with(of_fluid), ElementsAre("fluid")) << of_fluid;
    for (const char* of_surfaces : {"wall_normal, 16 bytes", "wall_distance, 8 bytes"})
        EXPECT_THAT(kinds_with(of_surfaces), ElementsAre("rigid", "elastic")) << of_surfaces;
    for (const char* of_bodies : {"opposite_distance, 8 bytes", "surface_gradient, 32 bytes"})
        EXPECT_THAT(kinds_with(of_bodies), ElementsAre("elastic")) << of_bodies;
    EXPECT_THAT(kinds_with("wall_contact_range, 8 bytes"), ElementsAre("rigid", "elastic"));
}

TEST(Plan, plain_walls_carry_a_density) {
    const SceneAndParticles made =
        case_of("vein_valve", {"particles.spacing=0.4 mm", "numerics.scheme=plain", "numerics.walls=plain"});
    const auto fields = Simulation(made.scene, made.particles, 1).plan().fields;
    EXPECT_THAT(fields, testing::IsSupersetOf(
                            {"fluid: density, 8 bytes", "rigid: density, 8 bytes", "elastic: density, 8 bytes"}));
}

TEST(Setup, sound_speed_is_the_scenes_or_ten_times_the_largest_speed) {
    SceneAndParticles made = endless_water();
    EXPECT_DOUBLE_EQ(sound_speed(made.scene), 10);
    made.scene.numerics.sound_speed = 33.0;
    EXPECT_DOUBLE_EQ(sound_speed(made.scene), 33);
}

TEST(Setup, repulsion_is_as_strong_as_the_scene_says_or_a_small_part_of_the_fluids_stiffness) {
    SceneAndParticles made = endless_water();
    made.scene.contact.range = 1.0;
    const double automatic = pair_settings(made.scene, 1).repulsion_strength;
    EXPECT_GT(automatic, 0);
    EXPECT_LT(automatic, 0.1 * 1000 * 10 * 10 * 0.1 * 0.1);
    made.scene.dimension = 3;  // its energy is a length less than that on 1 m of depth
    EXPECT_DOUBLE_EQ(pair_settings(made.scene, 1).repulsion_strength, automatic * made.scene.particles.spacing);
    made.scene.contact.strength = 0.5;
    EXPECT_EQ(pair_settings(made.scene, 1).repulsion_strength, 0.5);
    made.scene.contact.range = 0.0;
    EXPECT_EQ(pair_settings(made.scene, 1).repulsion_strength, 0);
}

TEST(Setup, part_the_scene_does_not_know_is_an_error) {
    SceneAndParticles made = endless_water();
    made.particles.parts[0].name = "milk";
    try {
        const Simulation simulation(made.scene, made.particles, 1);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problem(), "the particles have a part 'milk' that is not in the scene");
        EXPECT_EQ(error.what_to_do(), "mesh the scene again");
    }
}

}  // namespace
}  // namespace dmp::tests::solver_run_tests
