// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/rest_test.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/errors.hpp"
#include "cli/uses.hpp"
#include "solver/simulation.hpp"

namespace dmp::cli {

namespace {

/// Keeps the fluid of the first frame, and how far it has gone in the last one.
class Moves : public FrameSink {
  public:
    explicit Moves(const ParticleSet& particles) : particles_(particles) {}

    void write(const Frame& frame) override {
        largest_ = 0;
        for (const FrameGroup& group : frame.groups) {
            if (group.name != "fluid") continue;
            for (std::size_t k = 0; k < group.size(); ++k) {
                const Vec here(group.position[3 * k], group.position[3 * k + 1], group.position[3 * k + 2]);
                const auto [start, is_new] = start_.try_emplace(group.id[k], here);
                if (!is_new) largest_ = std::max(largest_, distance(here, start->second));
            }
        }
    }
    [[nodiscard]] double largest() const { return largest_ / particles_.spacing; }

  private:
    [[nodiscard]] double distance(const Vec& a, const Vec& b) const {
        Vec apart = a - b;
        for (int axis = 0; axis < 3; ++axis) {
            const double period = particles_.box.extent()[axis];
            if (particles_.periodic.at(static_cast<std::size_t>(axis)))
                apart[axis] -= period * std::round(apart[axis] / period);
        }
        return apart.norm();
    }

    const ParticleSet& particles_;
    std::unordered_map<std::int64_t, Vec> start_;
    double largest_ = 0;
};

Scene at_rest(Scene scene, double sound_speed) {
    scene.numerics.sound_speed = sound_speed;
    for (Expression& g : scene.flow.acceleration) g = {};
    scene.flow.pressure_gradient = {};
    scene.flow.initial_velocity = {};
    scene.flow.initial_pressure = {};
    for (Part& part : scene.parts) {
        part.surface_velocity = {};
        part.velocity = {};
        part.spin = {};
        part.initial_velocity = {};
    }
    scene.forces.clear();
    scene.moving_shapes.clear();
    scene.solidify.clear();
    scene.breaking.clear();
    scene.species.clear();
    scene.measures.clear();
    scene.regions.clear();
    scene.output.fields = {FluidField::velocity};
    return scene;
}

}  // namespace

MeshReport::RestLine rest_test(const Scene& scene, const ParticleSet& particles, long steps) {
    Scene quiet = at_rest(scene, Simulation(scene, particles).plan().sound_speed);
    const Plan plan = Simulation(quiet, particles).plan();
    RunOptions options;
    // Steps follow what the particles do, and are longer than planned where they do little.
    constexpr double longer = 1.2;
    options.until = longer * static_cast<double>(steps) * plan.dt;
    quiet.output.every = options.until;
    Moves moves(particles);
    options.sink = &moves;
    MeshReport::RestLine settled;
    try {
        const RunSummary summary = Simulation(quiet, particles).run(options);
        settled.steps = summary.steps;
        settled.lost = summary.lost;
    } catch (const DivergenceError& error) {
        settled.fault = error.problem();
    }
    settled.largest_move = moves.largest();
    return settled;
}

}  // namespace dmp::cli
