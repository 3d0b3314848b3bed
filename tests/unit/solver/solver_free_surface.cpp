// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Liquids with a free surface, under body forces.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "solver/run/free_surface.hpp"
#include "solver/run/sound_speed.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_free_surface_tests {
namespace {

constexpr double height = 1, gravity = 9.81, density = 1000;  // [m], [m/s^2], [kg/m^3]
constexpr int wall_rows = 3;

void add(ParticleSet& set, const Vec& position, int part, const Vec& from_surface) {
    const double volume = set.spacing * set.spacing;
    set.position.push_back(position);
    set.volume.push_back(volume);
    set.mass.push_back(density * volume);
    set.part.push_back(part);
    set.body.push_back(-1);
    set.fixed.push_back(part == 1 ? 1 : 0);
    set.seated.push_back(0);
    const double depth = from_surface.norm();
    set.wall_normal.push_back(depth > 0 ? Vec(-from_surface / depth) : Vec(Vec::Zero()));
    set.wall_distance.push_back(depth);
}

/// A basin of a thick liquid 1 m deep and `columns` particles wide, `rows` deep, open at the top; gravity is switched
/// on softly.
SceneAndParticles basin(int columns, int rows) {
    SceneAndParticles made = endless_water();
    Scene& scene = made.scene;
    const double dx = height / rows, width = columns * dx;
    scene.particles.spacing = dx;
    scene.parts[0].viscosity = 300.0;  // sets it at rest within seconds
    Part wall;
    wall.name = std::string("wall");
    wall.kind = PartKind::rigid;
    wall.layers = wall_rows;
    scene.parts.push_back(wall);
    const std::string g = "-9.81 * (1 - exp(-t / 0.3))";
    scene.flow.acceleration[1] = Expression(g, g);
    scene.flow.periodic = {false, false, false};
    scene.flow.largest_speed = 0.1;
    scene.run.duration = 4.0;
    scene.output.every = 4.0;

    ParticleSet& set = made.particles;
    set = ParticleSet();
    set.spacing = dx;
    set.parts = {{"water", PartKind::fluid}, {"wall", PartKind::rigid}};
    for (int row = -wall_rows; row < rows + 5; ++row)
        for (int column = -wall_rows; column < columns + wall_rows; ++column) {
            const Vec position((column + 0.5) * dx, (row + 0.5) * dx, 0);
            const Vec surface(std::clamp(position[0], 0.0, width), std::max(position[1], 0.0), 0);
            if (position != surface)
                add(set, position, 1, position - surface);
            else if (row < rows)
                add(set, position, 0, Vec::Zero());
        }
    set.box = {Vec(-wall_rows * dx, -wall_rows * dx, 0), Vec(width + wall_rows * dx, height + 5 * dx, 0)};
    return made;
}

/// Pressure of a Tait liquid at rest, at this depth below its surface.
double pressure_at(double depth, double sound_speed) {
    const double sixth = 1 + 6 * gravity * depth / (sound_speed * sound_speed);
    return sound_speed * sound_speed * density / 7 * (std::pow(sixth, 7.0 / 6) - 1);
}

/// Depth of a liquid that was 1 m deep at its rest density: at the bottom it carries the same weight.
double settled_depth(double sound_speed) {
    const double pressure = 7 * gravity * height / (sound_speed * sound_speed) + 1;
    return sound_speed * sound_speed / (6 * gravity) * (std::pow(pressure, 6.0 / 7) - 1);
}

struct Rest {
    double pressure_error = 0;  ///< largest, of the pressure at the bottom [-]
    double top = 0;             ///< of the highest particle [m]
    double speed = 0;           ///< largest [m/s]
    RunSummary summary;
};

Rest rest_test(const SceneAndParticles& made, int threads = 1) {
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    Rest rest;
    rest.summary = Simulation(made.scene, made.particles, threads).run(options);
    const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
    const FrameField& pressure = *field_of(fluid, "pressure");
    const FrameField& velocity = *field_of(fluid, "velocity");
    const double c0 = rest.summary.sound_speed, depth = settled_depth(c0);
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double z = fluid.position[3 * k + 1];
        const double error = std::abs(pressure.values[k] - pressure_at(depth - z, c0)) / pressure_at(depth, c0);
        rest.pressure_error = std::max(rest.pressure_error, error);
        rest.top = std::max(rest.top, z);
        rest.speed =
            std::max(rest.speed, std::hypot(double(velocity.values[3 * k]), double(velocity.values[3 * k + 1])));
    }
    return rest;
}

TEST(FreeSurface, is_found_where_fluid_has_no_neighbours_on_one_side) {
    SceneAndParticles open = basin(10, 10);
    EXPECT_TRUE(has_free_surface(open.particles, 2));
    EXPECT_FALSE(has_free_surface(endless_water().particles, 1));
    SceneAndParticles cut = endless_water();
    cut.particles.periodic[1] = false;
    EXPECT_TRUE(has_free_surface(cut.particles, 1));
    for (const char* confined : {"vein_valve", "bent_channel", "verification/poiseuille"})
        EXPECT_FALSE(has_free_surface(case_of(confined, {}).particles, 2)) << confined;
}

TEST(SoundSpeed, follows_from_the_largest_speed_or_the_pressure_of_the_column) {
    const auto chosen = [](const SceneAndParticles& made) { return choose_sound_speed(made.scene, made.particles); };
    SceneAndParticles made = basin(10, 10);
    const double settled = 9.81 * (1 - std::exp(-4 / 0.3));  // gravity at the end
    EXPECT_NEAR(chosen(made).largest_pressure, 1000 * settled * 1, 1e-6);
    EXPECT_NEAR(chosen(made).value, 10 * std::sqrt(settled * 1), 1e-9);
    EXPECT_EQ(chosen(made).origin, SoundSpeed::Origin::column_pressure);

    made.scene.flow.largest_speed = 4.0;
    EXPECT_EQ(chosen(made).value, 40);
    EXPECT_EQ(chosen(made).origin, SoundSpeed::Origin::largest_speed);

    made.scene.flow.largest_pressure = 40000.0;
    EXPECT_DOUBLE_EQ(chosen(made).value, std::sqrt(40000 / 10.0));
    EXPECT_EQ(chosen(made).origin, SoundSpeed::Origin::given_pressure);

    made.scene.numerics.sound_speed = 7.0;
    EXPECT_EQ(chosen(made).value, 7);
    EXPECT_EQ(chosen(made).origin, SoundSpeed::Origin::scene);
}

TEST(SoundSpeed, of_a_viscous_fluid_keeps_the_density_of_slow_flow) {
    SceneAndParticles made = endless_water("50");
    made.scene.parts[0].viscosity = 20000.0;  // Pa s, at 1 m/s
    const SoundSpeed viscous = choose_sound_speed(made.scene, made.particles);
    EXPECT_EQ(viscous.origin, SoundSpeed::Origin::viscous_pressure);
    EXPECT_DOUBLE_EQ(viscous.largest_pressure, 20000 * 1 / (4 * made.scene.particles.spacing.value));
    EXPECT_DOUBLE_EQ(viscous.value, 10 * std::sqrt(viscous.largest_pressure / 1000));
    // The step is then that of the viscosity.
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    EXPECT_EQ(plan.sound_speed, viscous.value);
    EXPECT_EQ(plan.limits.front().model, "sound");
    EXPECT_GT(plan.limits.front().dt, 4 * plan.dt);

    for (const auto& leave_out : {+[](Scene& s) { s.numerics.scheme = FluidScheme::plain; },
                                  +[](Scene& s) { s.numerics.viscosity_stepping = ViscosityStepping::implicitly; }}) {
        Scene scene = made.scene;
        leave_out(scene);
        EXPECT_EQ(choose_sound_speed(scene, made.particles).origin, SoundSpeed::Origin::largest_speed);
    }
}

TEST(SoundSpeed, of_a_fluid_driven_along_a_periodic_axis_is_ten_times_its_speed) {
    const SceneAndParticles made = endless_water("50");
    EXPECT_DOUBLE_EQ(choose_sound_speed(made.scene, made.particles).value, 10);
    EXPECT_DOUBLE_EQ(Simulation(made.scene, made.particles, 1).plan().sound_speed, 10);
    const SceneAndParticles column = basin(10, 10);
    EXPECT_DOUBLE_EQ(Simulation(column.scene, column.particles, 1).plan().sound_speed,
                     choose_sound_speed(column.scene, column.particles).value);
}

/// With the default terms, shifting and diffusion among them.
TEST(FreeSurface, column_settles_to_the_hydrostatic_pressure) {
    for (const bool corrected : {true, false})
        for (const int rows : {20, 50}) {
            SceneAndParticles made = basin(10, rows);
            if (!corrected) use_plain_scheme(made.scene);
            const Rest rest = rest_test(made);
            EXPECT_LE(rest.pressure_error, corrected ? 0.0055 : 0.005) << rows;
            EXPECT_LE(rest.speed, 1e-3 * std::sqrt(gravity * height)) << rows;
            // The surface is where the weight says, within a fifth of a spacing: nobody was shifted out of the fluid.
            const double dx = made.particles.spacing;
            EXPECT_NEAR(rest.top, settled_depth(rest.summary.sound_speed) - 0.5 * dx, 0.2 * dx) << rows;
            EXPECT_EQ(rest.summary.lost, 0U);
            EXPECT_LT(rest.summary.momentum_residual, 1e-12);
        }
}

TEST(FreeSurface, column_is_the_same_bits_on_any_number_of_threads) {
    SceneAndParticles made = basin(10, 10);
    made.scene.run.duration = made.scene.output.every = 0.2;
    EXPECT_EQ(rest_test(made, 3).summary.state_hash, rest_test(made).summary.state_hash);
}

TEST(FreeSurface, is_named_in_the_plan_with_what_minds_it) {
    const auto sources = [](const SceneAndParticles& made) {
        std::string all;
        for (const ModelUse& use : Simulation(made.scene, made.particles, 1).plan().models) all += use.source + "\n";
        return all;
    };
    const char *of_surface = "not across a free surface", *of_gravity = "less what is hydrostatic";
    EXPECT_THAT(sources(basin(10, 10)), testing::HasSubstr(of_surface));
    EXPECT_THAT(sources(endless_water("9.81")), testing::Not(testing::HasSubstr(of_surface)));
    SceneAndParticles plain = basin(10, 10), endless = endless_water("9.81");
    use_plain_scheme(plain.scene);
    use_plain_scheme(endless.scene);
    for (const char* text : {of_gravity, of_surface}) {
        EXPECT_THAT(sources(plain), testing::HasSubstr(text));
        EXPECT_THAT(sources(endless), testing::Not(testing::HasSubstr(text)));
    }
}

}  // namespace
}  // namespace dmp::tests::solver_free_surface_tests
