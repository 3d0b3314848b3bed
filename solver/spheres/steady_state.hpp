// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "solver/results/run_summary.hpp"
#include "solver/spheres/sphere_step.hpp"

namespace dmp::solver {

/// Finds when nothing changes any more: for the time asked for, no two spheres, nor a sphere and a wall, have come into
/// contact or lost it, and the kinetic energy stayed within 10^-3 of the largest one so far. That holds for spheres in
/// free flight, for those that came to rest, and for those that stick to others and hardly swing any more.
class SteadyState {
  public:
    /// 0: not asked for; then nothing is looked at.
    explicit SteadyState(double window) : window_(window) {}

    [[nodiscard]] bool wanted() const { return window_ > 0; }
    /// To be called after each step; looks now and then only. All ranks together.
    void update(double time, const SphereStep& step, const Ranks& ranks);
    [[nodiscard]] bool reached() const { return reached_ > 0; }
    [[nodiscard]] double since() const { return reached() ? quiet_since_ : 0; }
    void archive(Archive& file);

  private:
    double window_;
    double next_check_ = 0, quiet_since_ = 0, energy_then_ = 0, largest_energy_ = 0;
    std::int64_t contacts_then_ = -1;
    double reached_ = 0;
};

/// A number that tells which spheres touch which, and which walls: equal while that does not change. The same on all
/// ranks.
std::int64_t fingerprint_of_contacts(const SphereStep& step, const Ranks& ranks);

/// Kinetic energy of free spheres of all ranks.
SphereEnergy kinetic_energy(const SphereStep& step, const Ranks& ranks);

}  // namespace dmp::solver
