// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What frames show of the fluid, on any number of ranks: against closed forms, and the bits of one rank alone.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "scene/measure_columns.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/output/residence_times.hpp"
#include "solver/run/setup.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::results_tests {
namespace {

constexpr double spacing = 0.1, viscosity = 0.7;

const Ranks& all_ranks() {
    static const Ranks ranks = Ranks::world();
    return ranks;
}

Scene water_scene(int dimension) {
    Scene scene;
    scene.dimension = dimension;
    scene.particles.spacing = spacing;
    Part water;
    water.name = std::string("water");
    water.kind = PartKind::fluid;
    water.density = 1000.0;
    water.viscosity = viscosity;
    scene.parts = {water};
    scene.flow.largest_speed = 1.0;
    scene.run.duration = 1.0;
    return scene;
}

/// Water of `side` particles along each axis, off their lattice by up to `disorder` spacings.
ParticleSet water(int dimension, int side, double disorder, bool periodic) {
    ParticleSet set;
    set.dimension = dimension;
    set.spacing = spacing;
    const double length = side * spacing;
    set.box = {Vec::Zero(), Vec(length, length, dimension == 3 ? length : 0)};
    for (int axis = 0; axis < dimension; ++axis) set.periodic[axis] = periodic;
    set.parts = {{"water", PartKind::fluid}};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> off(-disorder * spacing, disorder * spacing);
    const auto position = [&](int k) { return (k + 0.5) * spacing + off(random); };
    for (int z = 0; z < (dimension == 3 ? side : 1); ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double height = dimension == 3 ? position(z) : 0;
                const double up = position(y);
                set.position.emplace_back(position(x), up, height);
                set.volume.push_back(std::pow(spacing, dimension));
                set.mass.push_back(1000 * set.volume.back());
                set.part.push_back(0);
                set.body.push_back(-1);
                set.fixed.push_back(0);
                set.seated.push_back(0);
                set.wall_normal.emplace_back(Vec::Zero());
                set.wall_distance.push_back(0);
            }
    return set;
}

/// A moment of water that moves as it is told.
class Moment {
  public:
    template <class VelocityAt>
    Moment(Scene scene, const ParticleSet& set, const Ranks& ranks, const VelocityAt& velocity_at)
        : scene_(std::move(scene)),
          ranks_(ranks),
          particles_(set, rest_densities(scene_, set), ranks_),
          step_(scene_, set, particles_, pair_settings(scene_, 1), equations_of_state(scene_, set), ranks_),
          residence_times_(scene_, particles_) {
        fill_store(scene_, set, particles_);
        ParticleGroup& fluid = particles_.fluid();
        for (std::size_t i = 0; i < fluid.owned(); ++i) {
            Vec x = Vec::Zero();
            for (int axis = 0; axis < set.dimension; ++axis) x[axis] = fluid.data(Field::position, axis)[i];
            const Vec v = velocity_at(x);
            for (int axis = 0; axis < set.dimension; ++axis) fluid.data(Field::velocity, axis)[i] = v[axis];
            fluid.data(Field::density)[i] = 1000 + x[0];  // so that there is a pressure
        }
        step_.refresh_neighbours();
        step_.take_initial_gradients(0);
    }
    void advance(double time, double dt) {
        step_.advance(time, dt);
        residence_times_.add(particles_, dt, 1);
    }
    /// Values by particle number, of all ranks, on each of them.
    std::map<std::int64_t, std::vector<double>> values(FluidField field, std::size_t array = 0) {
        const FluidValues found = FluidFields(scene_, particles_, step_).of(field).at(array);
        std::vector<std::int64_t> ids;
        for (std::size_t i = 0; i < particles_.fluid().owned(); ++i) ids.push_back(particles_.fluid().tags()[i].id);
        const auto all_ids = ranks_.all_gather(ids);
        const auto all = ranks_.all_gather(found.values);
        std::map<std::int64_t, std::vector<double>> by_id;
        const auto width = static_cast<std::size_t>(found.components);
        EXPECT_EQ(all.size(), width * all_ids.size());
        for (std::size_t k = 0; k < all_ids.size(); ++k)
            for (std::size_t c = 0; c < width; ++c) by_id[all_ids[k]].push_back(all[width * k + c]);
        return by_id;
    }

  private:
    Scene scene_;
    Ranks ranks_;
    ParticleStore particles_;
    FluidStep step_;
    ResidenceTimes residence_times_;
};

double pressure_of(Moment& moment, std::int64_t id) { return moment.values(FluidField::pressure).at(id).at(0); }

TEST(Results, of_solid_body_rotation_are_twice_its_rate_and_no_shear_anywhere) {
    constexpr double rate = 3;
    const ParticleSet set = water(2, 16, 0.2, false);
    Moment moment(water_scene(2), set, all_ranks(), [](const Vec& x) { return Vec(-rate * x[1], rate * x[0], 0); });
    const auto vorticity = moment.values(FluidField::vorticity), shear = moment.values(FluidField::shear_stress);
    const auto stress = moment.values(FluidField::stress), von_mises = moment.values(FluidField::von_mises);
    const auto pressure = moment.values(FluidField::pressure);
    ASSERT_EQ(vorticity.size(), set.size());
    for (const auto& [id, curl] : vorticity) {
        ASSERT_EQ(curl.size(), 1U) << "in 2-D";
        EXPECT_NEAR(curl[0], 2 * rate, 1e-9);
        EXPECT_NEAR(shear.at(id)[0], 0, 1e-9);
        EXPECT_NEAR(von_mises.at(id)[0], 0, 1e-8);
        for (int c = 0; c < 6; ++c) EXPECT_NEAR(stress.at(id)[c], c < 3 ? -pressure.at(id)[0] : 0, 1e-8) << c;
    }
    EXPECT_GT(std::abs(pressure.at(5)[0]), 1) << "else nothing was tested";
}

TEST(Results, of_simple_shear_are_viscosity_times_rate_anywhere) {
    constexpr double rate = 5;
    const ParticleSet set = water(2, 16, 0.2, false);
    Moment moment(water_scene(2), set, all_ranks(), [](const Vec& x) { return Vec(rate * x[1], 0, 0); });
    const auto stress = moment.values(FluidField::stress), von_mises = moment.values(FluidField::von_mises);
    const auto vorticity = moment.values(FluidField::vorticity);
    for (const auto& [id, shear] : moment.values(FluidField::shear_stress)) {
        EXPECT_NEAR(shear[0], viscosity * rate, 1e-9);
        EXPECT_NEAR(stress.at(id)[3], viscosity * rate, 1e-9);
        EXPECT_NEAR(von_mises.at(id)[0], std::sqrt(3.0) * viscosity * rate, 1e-8);
        EXPECT_NEAR(vorticity.at(id)[0], -rate, 1e-9);
    }
}

TEST(Results, in_space_have_all_components) {
    const ParticleSet set = water(3, 7, 0.15, false);
    // v = (2 z, 3 x, 4 y + z)
    Moment moment(water_scene(3), set, all_ranks(),
                  [](const Vec& x) { return Vec(2 * x[2], 3 * x[0], 4 * x[1] + x[2]); });
    const std::int64_t id = 100;
    const double p = pressure_of(moment, id);
    const auto curl = moment.values(FluidField::vorticity).at(id);
    const auto stress = moment.values(FluidField::stress).at(id);
    ASSERT_EQ(curl.size(), 3U);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(curl[axis], Vec(4, 2, 3)[axis], 1e-9);
    const std::array expected{-p, -p, 2 * viscosity - p, 3 * viscosity, 4 * viscosity, 2 * viscosity};
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(stress[c], expected[c], 1e-8) << tensor_components[c];
}

TEST(Results, are_the_bits_of_one_rank_alone) {
    const ParticleSet set = water(2, 16, 0.2, true);
    const auto wavy = [](const Vec& x) { return Vec(std::sin(7 * x[1]), 0.3 * std::cos(9 * x[0] + x[1]), 0); };
    Moment alone(water_scene(2), set, Ranks::alone(), wavy), together(water_scene(2), set, all_ranks(), wavy);
    for (const FluidField field :
         {FluidField::shear_stress, FluidField::stress, FluidField::von_mises, FluidField::vorticity})
        EXPECT_EQ(alone.values(field), together.values(field)) << to_string(field);
}

constexpr double speed = 0.5;

TEST(ResidenceTimes, of_a_crossing_are_length_over_speed) {
    constexpr double dt = 0.008;
    Scene scene = water_scene(2);
    ResidenceRegion strip, corner;
    strip.name = std::string("strip");
    strip.from = Vec(0.9, -1, 0);  // across the geometry, corners the other way round
    strip.to = Vec(0.6, 2, 0);
    corner.name = std::string("corner");
    corner.from = Vec(0, 0, 0);
    corner.to = Vec(1.6, 0.4, 0);
    scene.regions = {strip, corner};
    scene.output.fields = {FluidField::residence_time};
    scene.numerics.density_diffusion = 0.0;
    const ParticleSet set = water(2, 16, 0, true);
    Moment moment(scene, set, all_ranks(), [](const Vec& /*x*/) { return Vec(speed, 0, 0); });
    const double period = 1.6 / speed;
    const int steps = static_cast<int>(std::lround(period / dt));
    for (int step = 0; step < steps; ++step) moment.advance(step * dt, dt);
    const auto in_strip = moment.values(FluidField::residence_time, 0);
    const auto in_corner = moment.values(FluidField::residence_time, 1);
    ASSERT_EQ(in_strip.size(), set.size());
    double off = 0;
    for (const auto& [id, time] : in_strip) {
        off = std::max(off, std::abs(time[0] - 0.3 / speed));
        const bool below = set.position[static_cast<std::size_t>(id)][1] < 0.4;
        EXPECT_NEAR(in_corner.at(id)[0], below ? period : 0, 1e-9);
    }
    EXPECT_LE(off, 1.5 * dt);
}

TEST(ResidenceTimes, cost_no_field_when_they_are_not_asked_for) {
    Scene scene = water_scene(2);
    scene.regions.resize(1);
    scene.regions[0].to = Vec(1, 1, 0);
    ParticleStore particles(water(2, 8, 0, true), {1000.0}, all_ranks());
    const ResidenceTimes times(scene, particles);
    EXPECT_FALSE(particles.fluid().has(Field::residence_time));
    times.add(particles, 1, 1);
}

}  // namespace
}  // namespace dmp::tests::results_tests
