// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/spheres/free_flight.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// Four numbers that are read and written together.
struct alignas(32) Row {
    double c[4] = {};
};

/// What contacts need to know of a sphere, side by side: a contact meets two spheres anywhere in memory and then finds
/// each in two lines of the cache, not in a dozen.
struct SphereMotion {
    Row position;  ///< x, y, z and radius [m]
    Row velocity;  ///< [m/s] and, for effective masses, mass [kg]; a fixed sphere's is 2^60 times its own
    Row spin;      ///< angular velocity [1/s] and 1 / mass [1/kg]; 0: fixed

    [[nodiscard]] double radius() const { return position.c[3]; }
    [[nodiscard]] double inverse_mass() const { return spin.c[3]; }
    [[nodiscard]] bool fixed() const { return spin.c[3] == 0; }
};

/// What other spheres do to a sphere.
struct alignas(64) SphereLoad {
    Row force;   ///< [N]
    Row torque;  ///< [N m]
};

inline constexpr std::size_t motion_width = sizeof(SphereMotion) / sizeof(double);
inline constexpr std::size_t load_width = sizeof(SphereLoad) / sizeof(double);
static_assert(motion_width == 12 && load_width == 8);

/// The owned spheres and, behind them, their copies, in the order of the group. While the order lasts, places and
/// velocities are kept here and nowhere else. Two more rows stand for spheres that never touch, for lanes without a
/// contact. Places of spheres in free flight are those of the last landing;
/// their copies' on other ranks those of the last look.
class SphereRows {
  public:
    explicit SphereRows(int threads = 1) : flight_(threads) {}

    /// Takes everything from the group: owned spheres and copies. None flies.
    void take(const ParticleGroup& group, const std::vector<bool>& fixed_by_id);
    /// Gives places, velocities and spins of owned spheres back.
    void give(ParticleGroup& group);

    [[nodiscard]] FreeFlight& flight() { return flight_; }
    [[nodiscard]] const FreeFlight& flight() const { return flight_; }
    void land() { flight_.land(motion_); }

    [[nodiscard]] std::size_t owned() const { return owned_; }
    [[nodiscard]] std::size_t total() const { return motion_.size() < 2 ? 0 : motion_.size() - 2; }
    [[nodiscard]] std::span<SphereMotion> motion() { return motion_; }
    [[nodiscard]] std::span<const SphereMotion> motion() const { return motion_; }
    [[nodiscard]] std::span<SphereLoad> loads() { return loads_; }
    [[nodiscard]] std::span<const SphereLoad> loads() const { return loads_; }
    /// The first of the two rows that never touch.
    [[nodiscard]] std::int32_t nobody() const { return static_cast<std::int32_t>(total()); }
    [[nodiscard]] std::size_t bytes() const {
        return motion_.capacity() * sizeof(SphereMotion) + loads_.capacity() * sizeof(SphereLoad);
    }

  private:
    std::size_t owned_ = 0;
    std::vector<SphereMotion> motion_;
    std::vector<SphereLoad> loads_;
    FreeFlight flight_;
};

}  // namespace dmp::solver
