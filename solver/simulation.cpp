// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/simulation.hpp"

#include "solver/run/fluid_run.hpp"
#include "solver/spheres/sphere_run.hpp"

namespace dmp::solver {

namespace {

std::unique_ptr<Run> make_run(const Scene& scene, const ParticleSet& particles, const Resources& resources) {
    if (particles.has_spheres()) return std::make_unique<SphereRun>(scene, particles, resources);
    return std::make_unique<FluidRun>(scene, particles, resources);
}

}  // namespace

Simulation::Simulation(const Scene& scene, const ParticleSet& particles, const Resources& resources)
    : run_(make_run(scene, particles, resources)) {}

long Simulation::resume(const std::filesystem::path& checkpoint) {
    // Rank 0 has checked the file's seal before it was chosen.
    return run_->resume(Hdf5Reader(checkpoint));
}

void Simulation::start_from(const std::filesystem::path& checkpoint) { run_->start_from(Hdf5Reader(checkpoint)); }

}  // namespace dmp::solver
