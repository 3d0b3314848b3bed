// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sweeps/single_points.hpp"

#include <cmath>

namespace dmp {

namespace {

/// Behind the last particle: nobody, and room for a vector's width.
constexpr std::size_t room_behind_the_end = 17;

}  // namespace

SinglePoints::SinglePoints(const SingleUnits& units, int dimension) : units_(units), dimension_(dimension) {}

void SinglePoints::fill(const ParticleGroup& fluid, int threads) {
    const auto& [length, sound_speed, density] = units_;
    fill_velocities(fluid, threads);
    take(fluid.data(Field::volume), std::pow(length, dimension_), volume_, threads);
    take(fluid.data(Field::density), density, density_, threads);
    take(fluid.data(Field::pressure), density * sound_speed * sound_speed, pressure_, threads);
    take(fluid.data(Field::viscosity), density * sound_speed * length, viscosity_, threads);
}

void SinglePoints::fill_velocities(const ParticleGroup& fluid, int threads) {
    size_ = fluid.total();
    for (int axis = 0; axis < dimension_; ++axis)
        take(fluid.data(Field::velocity, axis), units_.sound_speed, velocity_[static_cast<std::size_t>(axis)], threads);
}

void SinglePoints::take(const double* values, double unit, Array& into, int threads) const {
    into.resize(size_ + room_behind_the_end);
    const double per_unit = 1 / unit;
    const auto count = static_cast<std::ptrdiff_t>(size_);
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) into[i] = static_cast<float>(per_unit * values[i]);
    into[size_] = 0;
}

std::size_t SinglePoints::bytes() const {
    std::size_t numbers = volume_.capacity() + density_.capacity() + pressure_.capacity() + viscosity_.capacity();
    for (const Array& axis : velocity_) numbers += axis.capacity();
    return numbers * sizeof(float);
}

}  // namespace dmp
