// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/residence_times.hpp"

#include "particles/periodic_images.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

ResidenceTimes::ResidenceTimes(const Scene& scene, ParticleStore& particles) {
    if (!scene.asks_for(FluidField::residence_time)) return;
    regions_ = scene.regions;
    if (!regions_.empty()) particles.fluid().declare(Field::residence_time, static_cast<int>(regions_.size()));
}

void ResidenceTimes::add(ParticleStore& particles, double dt, int threads) const {
    if (regions_.empty()) return;
    ParticleGroup& fluid = particles.fluid();
    const ParticleSpace& space = particles.space();
    const auto count = static_cast<std::ptrdiff_t>(fluid.owned());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        Vec place = Vec::Zero();
        for (int axis = 0; axis < space.dimension; ++axis) {
            const double x = fluid.data(Field::position, axis)[i];
            place[axis] = space.periodic[axis] ? wrapped(x, space.box.low[axis], space.box.high[axis]) : x;
        }
        for (std::size_t r = 0; r < regions_.size(); ++r)
            if (regions_[r].contains(place, space.dimension))
                fluid.data(Field::residence_time, static_cast<int>(r))[i] += dt;
    }
}

}  // namespace dmp::solver
