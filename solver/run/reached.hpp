// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/state/archive.hpp"
#include "solver/time/fluid_step.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Compares the flow that a run reaches with the one for which the speed of sound was chosen, and warns where
/// - the density has left 0.95 to 1.05 of that at rest: the fluid no longer acts as an incompressible one;
/// - the largest speed is more than 1.5 times numerics.mach_number, and more than 0.15, of the speed of sound;
/// - at the end of a complete run: the flow was ten times slower than flow.largest_speed, from which the speed of sound
///   was chosen, or slower still.
class Reached {
  public:
    Reached(const Scene& scene, const SoundSpeed& sound);

    /// Adds the extremes of a step. Returns the warnings that it is the first to raise.
    std::vector<Warning> add(const FluidExtremes& extremes);
    [[nodiscard]] std::vector<Warning> warnings(bool complete) const;

    [[nodiscard]] double largest_speed() const { return speed_; }        ///< of the fluid [m/s]
    [[nodiscard]] double density_low() const { return density_low_; }    ///< over the rest density [-]
    [[nodiscard]] double density_high() const { return density_high_; }  ///< over the rest density [-]

    void archive(Archive& file);

  private:
    [[nodiscard]] bool compressed() const;
    [[nodiscard]] bool too_fast() const;
    [[nodiscard]] bool slow() const;
    [[nodiscard]] bool is_by_hand() const;  ///< the speed of sound
    [[nodiscard]] Warning too_low(const std::string& reason, const std::string& what_to_do) const;
    [[nodiscard]] Warning of_density() const;
    [[nodiscard]] Warning of_mach() const;
    [[nodiscard]] Warning of_slow_flow() const;

    const Scene& scene_;
    SoundSpeed sound_;
    double speed_ = 0, density_low_ = std::numeric_limits<double>::infinity(), density_high_ = 0;
};

}  // namespace dmp::solver
