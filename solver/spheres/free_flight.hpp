// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/store/position_quantum.hpp"

namespace dmp::solver {

struct SphereMotion;

/// Which spheres a step has to look at, and which fly freely: nothing can act on them before contacts are next looked
/// for, or walls listed. Velocities of those stay, and each step takes them as far as the one before; so many steps are
/// made at once, when somebody asks where they are. Ways are whole quanta of places: the sum of many is, to the bit,
/// that of one after the other.
class FreeFlight {
  public:
    explicit FreeFlight(int threads) : threads_(threads) {}

    /// Of the first `owned` rows none flies.
    void end(std::size_t owned);
    /// Those rows fly that nothing acts on; places are present ones.
    void begin(std::span<const std::uint8_t> acted_on);
    /// In any order that threads may share: of rows.
    [[nodiscard]] std::span<const std::int32_t> busy() const { return busy_; }
    [[nodiscard]] std::span<const std::int32_t> flying() const { return flying_; }

    /// One more step for those that fly.
    void pass(double dt, const PositionQuantum& quantum, std::span<SphereMotion> motion);
    /// Brings those that fly to where they are.
    void land(std::span<SphereMotion> motion);

  private:
    int threads_;
    std::vector<std::int32_t> busy_, flying_;
    long steps_ = 0;             ///< since those that fly were last brought up
    double dt_ = 0, magic_ = 0;  ///< of all these steps [s], and PositionQuantum's
};

}  // namespace dmp::solver
