// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "solver/simulation.hpp"
#include "solver/state/checkpoints.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

inline constexpr double spacing = 0.1;

/// A scene with its particles, made without a geometry: a rectangle of water from (0, 0), of density 1000 and particles
/// 0.1 m apart, and three rows of wall particles around it.
struct WalledWater {
    Scene scene;
    ParticleSet particles;

    /// `wall_of(column, row)`: number of the rigid part, from 1, that has the lattice cell outside the rectangle; 0:
    /// none.
    WalledWater(int columns, int rows, const std::vector<std::string>& walls,
                const std::function<int(int, int)>& wall_of) {
        scene.particles.spacing = spacing;
        scene.output.every = 1e3;
        scene.output.fields = {FluidField::velocity, FluidField::pressure, FluidField::density};
        scene.flow.largest_speed = 1.0;
        scene.run.duration = 1.0;
        Part water;
        water.name = std::string("water");
        water.kind = PartKind::fluid;
        water.density = 1000.0;
        water.viscosity = 100.0;
        scene.parts = {water};
        particles.spacing = spacing;
        particles.parts = {{"water", PartKind::fluid}};
        for (const std::string& name : walls) {
            Part wall;
            wall.name = name;
            wall.kind = PartKind::rigid;
            wall.layers = 3;
            scene.parts.push_back(wall);
            particles.parts.push_back({name, PartKind::rigid});
        }
        particles.box = {Vec::Zero(), Vec(columns * spacing, rows * spacing, 0)};
        const Vec extent = particles.box.high;
        for (int row = -3; row < rows + 3; ++row)
            for (int column = -3; column < columns + 3; ++column) {
                const Vec position((column + 0.5) * spacing, (row + 0.5) * spacing, 0);
                const Vec surface = position.cwiseMax(Vec::Zero()).cwiseMin(extent);
                const double depth = (surface - position).norm();
                const int part = depth > 0 ? wall_of(column, row) : 0;
                if (depth == 0)
                    add(0, position, Vec::Zero(), 0);
                else if (part > 0)
                    add(part, position, (surface - position) / depth, depth);
            }
    }

    /// Puts a particle there; `part` 0 is the water.
    void add(int part, const Vec& position, const Vec& normal, double depth) {
        particles.position.push_back(position);
        particles.volume.push_back(spacing * spacing);
        particles.mass.push_back(1000 * spacing * spacing);
        particles.part.push_back(part);
        particles.body.push_back(-1);
        particles.fixed.push_back(part > 0 ? 1 : 0);
        particles.seated.push_back(0);
        particles.wall_normal.push_back(normal);
        particles.wall_distance.push_back(depth);
    }

    void make_periodic(int axis) { particles.periodic[axis] = scene.flow.periodic[axis].value = true; }
    void mirror(const std::vector<BoxSide>& sides) {
        scene.flow.symmetry = sides;
        for (const BoxSide side : sides)
            particles.mirrored[side == BoxSide::x_low || side == BoxSide::x_high ? 0 : 1]
                              [side == BoxSide::x_low || side == BoxSide::y_low ? 0 : 1] = true;
    }
    Part& part(int number) { return scene.parts[static_cast<std::size_t>(number)]; }
};

inline Expression formula_of(const std::string& text) { return Expression(text, text); }

/// A run on these ranks, with a frame at its end. `made` has a scene and its particles.
template <class Made>
RunSummary run_of(const Made& made, FrameSink* sink = nullptr, const Ranks& ranks = Ranks::alone()) {
    Resources resources(1);
    resources.ranks = ranks;
    Scene scene = made.scene;
    if (scene.output.every > scene.run.duration) scene.output.every = scene.run.duration;
    Simulation simulation(scene, made.particles, resources);
    RunOptions options;
    options.sink = sink;
    return simulation.run(options);
}

/// Stops the run when it is given a frame of a later time than 0.
class StoppingSink : public FrameSink {
  public:
    explicit StoppingSink(std::atomic<bool>& stop) : stop_(stop) {}
    void write(const Frame& frame) override { stop_ = stop_ || frame.time > 0; }

  private:
    std::atomic<bool>& stop_;
};

/// The same, stopped at its first frame after the start and resumed by another process from its checkpoint.
template <class Made>
RunSummary run_in_two_parts(const Made& made, const std::filesystem::path& folder,
                            const Ranks& ranks = Ranks::alone()) {
    Resources resources(1);
    resources.ranks = ranks;
    std::atomic<bool> stop{false};
    StoppingSink sink(stop);
    RunOptions options;
    options.sink = &sink;
    options.stop = &stop;
    options.checkpoints.folder = folder;
    options.checkpoints.every = 0;
    Simulation(made.scene, made.particles, resources).run(options);
    stop = false;
    Simulation simulation(made.scene, made.particles, resources);
    simulation.resume(checkpoint_to_resume(folder, "", made.scene.run.duration).file);
    options.stop = nullptr;
    options.sink = nullptr;
    return simulation.run(options);
}

}  // namespace dmp::tests
