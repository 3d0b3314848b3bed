// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/store/particle_store.hpp"

namespace dmp {

/// What numbers in single precision are multiples of, so that none is far from 1 in whatever units a scene is given.
struct SingleUnits {
    double length;       ///< the particles' spacing [m]
    double sound_speed;  ///< [m/s]
    double density;      ///< [kg/m^3]
};

/// Fluid particles, copies too, in single precision. Behind the last one stands nobody, with a volume of 0: a neighbour
/// for lanes that have none.
class SinglePoints {
  public:
    SinglePoints(const SingleUnits& units, int dimension);

    /// Takes all values from the group.
    void fill(const ParticleGroup& fluid, int threads);
    /// Takes the velocities alone: the others are still what they were.
    void fill_velocities(const ParticleGroup& fluid, int threads);

    [[nodiscard]] const float* velocity(int axis) const { return velocity_[static_cast<std::size_t>(axis)].data(); }
    [[nodiscard]] const float* volume() const { return volume_.data(); }
    [[nodiscard]] const float* density() const { return density_.data(); }
    [[nodiscard]] const float* pressure() const { return pressure_.data(); }
    [[nodiscard]] const float* viscosity() const { return viscosity_.data(); }
    /// The group's positions [m], with nobody's behind them.
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t bytes() const;

  private:
    using Array = std::vector<float>;
    void take(const double* values, double unit, Array& into, int threads) const;

    SingleUnits units_;
    int dimension_;
    std::size_t size_ = 0;
    std::array<Array, 3> velocity_;
    Array volume_, density_, pressure_, viscosity_;
};

}  // namespace dmp
