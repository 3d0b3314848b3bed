// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Elastic solids that nothing holds: how they start, and what moves them as a whole.
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "solver/elastic/body_parts.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_free_solids_tests {
namespace {

using ::testing::HasSubstr;

/// A bar of 1 m x 0.3125 m at an angle to the lattice, which cuts cells of many sizes.
const std::string slanting = polygon({{0.3, 0.1},
                                      {1.239692620785908, 0.442020143325669},
                                      {1.132811325863918, 0.735674087195015},
                                      {0.193118705078010, 0.393653943869346}},
                                     "bar");
constexpr double area = 0.3125;

/// One of 1 m x 0.25 m on the lattice.
const std::string straight = polygon({{0, 0}, {1, 0}, {1, 0.25}, {0, 0.25}}, "bar");

Texts free_bar(const std::string& geometry, const std::string& more) {
    return {R"(schema = 1
[geometry]
file = "channel.geo"
[particles]
spacing = "0.0625 m"
[[part]]
name = "bar"
kind = "elastic"
model = "cells"
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.25
)" + more + R"([flow]
largest_speed = "1 m/s"
[numerics]
sound_speed = "20 m/s"
[contact]
range = 0
[run]
duration = "0.5 s"
[output]
every = "0.5 s"
fields = []
solid_fields = ["velocity", "displacement"]
)",
            geometry};
}

Texts of_springs(const Texts& texts) { return texts.with("model = \"cells\"", "model = \"springs\""); }

class AllFrames : public FrameSink {
  public:
    void write(const Frame& frame) override { frames.push_back(frame); }
    std::vector<Frame> frames;
};

/// A run with its frames.
struct Motion {
    Meshed meshed;
    RunSummary summary;
    std::vector<Frame> frames;

    /// Of the solid's particle k in a frame, by the name of a field.
    [[nodiscard]] Vec of(std::size_t frame, const std::string& name, std::size_t k) const {
        const FrameGroup& solid = group(frame);
        const FrameField& field = *std::ranges::find(solid.fields, name, &FrameField::name);
        return {field.values[3 * k], field.values[3 * k + 1], field.values[3 * k + 2]};
    }
    [[nodiscard]] const FrameGroup& group(std::size_t frame) const {
        return *std::ranges::find(frames.at(frame).groups, "solid", &FrameGroup::name);
    }
    [[nodiscard]] const Vec& drawn(std::size_t k) const {
        return meshed.particles.position[static_cast<std::size_t>(group(0).id[k])];
    }
};

Motion run(const Texts& texts) {
    Motion motion{mesh_texts(texts), {}, {}};
    AllFrames sink;
    RunOptions options;
    options.sink = &sink;
    motion.summary = Simulation(motion.meshed.scene, motion.meshed.particles, Resources(1)).run(options);
    motion.frames = std::move(sink.frames);
    return motion;
}

TEST(FreeSolids, of_cut_cells_are_not_strained_by_a_total_force) {
    const Motion motion = run(free_bar(
        slanting, "[[force]]\nname = \"pull\"\npart = \"bar\"\nforce = [\"300 N\", \"-100 N\"]\namount = \"total\"\n"));
    EXPECT_NEAR(motion.summary.end.momentum[0], 150, 1e-6);
    EXPECT_NEAR(motion.summary.end.momentum[1], -50, 1e-6);
    EXPECT_LT(motion.summary.momentum_residual, 1e-9);
    // s = F t^2 / 2 m, but for the first step.
    const double way = 300 * 0.125 / (1000 * area);
    const Vec first = motion.of(1, "displacement", 0);
    EXPECT_NEAR(first[0], way, 0.05 * way);
    for (std::size_t k = 0; k < motion.group(1).id.size(); ++k)
        EXPECT_LT((motion.of(1, "displacement", k) - first).norm(), 1e-6 * way);
}

TEST(FreeSolids, of_cut_cells_feel_a_force_that_asks_for_places_by_volume_too) {
    for (const auto* place : {"x > -1 m", "X > -1 m"}) {
        const Motion motion =
            run(free_bar(slanting, "[[force]]\nname = \"pull\"\npart = \"bar\"\nforce = [\"" + std::string(place) +
                                       " ? 300 N : 0\", 0]\namount = \"total\"\n"));
        EXPECT_NEAR(motion.summary.end.momentum[0], 150, 1e-6);
        const Vec first = motion.of(1, "displacement", 0);
        for (std::size_t k = 0; k < motion.group(1).id.size(); ++k)
            EXPECT_LT((motion.of(1, "displacement", k) - first).norm(), 1e-6 * first.norm());
    }
}

TEST(FreeSolids, keep_the_velocity_with_which_they_start) {
    const std::string start = "initial_velocity = [\"0.5 m/s\", \"-0.25 m/s\"]\n";
    for (const Texts& texts : {free_bar(slanting, start), of_springs(free_bar(straight, start))}) {
        const Motion motion = run(texts);
        double mass = 0;
        for (const double each : motion.meshed.particles.mass) mass += each;
        for (const auto& momentum : {motion.summary.start.momentum, motion.summary.end.momentum}) {
            EXPECT_NEAR(momentum[0], 0.5 * mass, 1e-9 * mass);
            EXPECT_NEAR(momentum[1], -0.25 * mass, 1e-9 * mass);
        }
        for (std::size_t k = 0; k < motion.group(0).id.size(); ++k) {
            EXPECT_LT((motion.of(0, "velocity", k) - Vec(0.5, -0.25, 0)).norm(), 1e-6);
            EXPECT_LT((motion.of(1, "velocity", k) - Vec(0.5, -0.25, 0)).norm(), 1e-6);
            EXPECT_LT((motion.of(1, "displacement", k) - Vec(0.25, -0.125, 0)).norm(), 1e-6);
        }
    }
}

/// Twice the energy of motion of the nodes.
double twice_kinetic_energy(const BodyParts& body) {
    double sum = 0;
    for (const auto& node : body.nodes) sum += node.mass * node.velocity.squaredNorm();
    return sum;
}

TEST(FreeSolids, that_start_turning_have_the_energy_of_their_moment_of_inertia_and_turn_on) {
    constexpr double spin = 2, length = 1, height = 0.25, a = 0.0625, mass = 1000 * length * height;
    const std::string start = "initial_velocity = [\"-2 * (y - 0.125 m) / (1 s)\", \"2 * (x - 0.5 m) / (1 s)\"]\n";
    // What is in one place turns with less than the solid.
    const double of_solid = mass * (length * length + height * height) / 12;
    for (const bool springs : {false, true}) {
        const Texts texts = springs ? of_springs(free_bar(straight, start)) : free_bar(straight, start);
        const Motion motion = run(texts);
        const ParticleSet& set = motion.meshed.particles;
        const InitialSprings drawn(set, motion.meshed.scene);
        const BodyParts body = springs ? initial_body(set, drawn, 0, 0) : initial_cells(set, drawn, 0, 0);
        const double inertia = of_solid - (springs ? mass * a * a / 6 : 0);
        EXPECT_NEAR(twice_kinetic_energy(body), inertia * spin * spin, 1e-9 * inertia);
        EXPECT_NEAR(motion.summary.start.momentum[0], 0, 1e-9 * mass);
        EXPECT_NEAR(motion.summary.end.momentum[1], 0, 1e-9 * mass);
        // After half a second it has turned by 1 rad; rho (omega L)^2 / 8 E = 0.05 % is what the spin stretches it by.
        const Vec middle(0.5, 0.125, 0);
        for (std::size_t k = 0; k < motion.group(1).id.size(); ++k) {
            const Vec arm = motion.drawn(k) - middle;
            const Vec turned(std::cos(1.0) * arm[0] - std::sin(1.0) * arm[1],
                             std::sin(1.0) * arm[0] + std::cos(1.0) * arm[1], 0);
            EXPECT_LT((motion.of(1, "displacement", k) - (turned - arm)).norm(), 0.005 * length);
        }
    }
}

TEST(FreeSolids, in_space_start_as_their_formula_says) {
    const std::string bar = R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 0.25, 0.25};
Physical Volume("bar") = {1};
)";
    const std::string start = "initial_velocity = [0, \"0.5 m/s\", \"x / (1 s)\"]\n";
    for (const bool springs : {false, true}) {
        const Texts texts = springs ? of_springs(free_bar(bar, start)) : free_bar(bar, start);
        const Motion motion = run(texts.with("schema = 1", "schema = 1\ndimension = 3"));
        EXPECT_NEAR(motion.summary.start.momentum[1], 0.5 * 62.5, 1e-9);
        EXPECT_NEAR(motion.summary.end.momentum[2], 0.5 * 62.5, 1e-7);
        for (std::size_t k = 0; k < motion.group(0).id.size(); ++k)
            EXPECT_LT((motion.of(0, "velocity", k) - Vec(0, 0.5, motion.drawn(k)[0])).norm(), 1e-6);
    }
}

TEST(FreeSolids, what_is_clamped_stays_at_rest) {
    const Motion motion = run(free_bar(straight + "Physical Curve(\"clamp\") = {4};\n",
                                       "anchor = \"clamp\"\ninitial_velocity = [0, \"0.1 m/s\"]\n"));
    const BodyParts body =
        initial_cells(motion.meshed.particles, InitialSprings(motion.meshed.particles, motion.meshed.scene), 0, 0);
    std::size_t held = 0;
    for (const auto& node : body.nodes) {
        EXPECT_EQ(node.velocity[1], node.fixed ? 0 : 0.1);
        held += node.fixed ? 1 : 0;
    }
    EXPECT_EQ(held, 5U);
}

TEST(FreeSolids, that_start_with_no_number_are_refused) {
    EXPECT_THAT(text_thrown<InputError>(
                    [] { run(free_bar(straight, "initial_velocity = [\"1 m/s * sqrt(0.5 - x / (1 m))\", 0]\n")); }),
                HasSubstr("initial_velocity is ("));
}

}  // namespace
}  // namespace dmp::tests::solver_free_solids_tests
