// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "solver/spheres/sphere_setup.hpp"

namespace dmp::solver {

/// numerics.contact_step, a time step of spheres that is set by hand: whether contacts bear it.
class StepByHand {
  public:
    StepByHand(const Scene& scene, const SphereSetup& setup) : scene_(scene), setup_(setup) {}

    [[nodiscard]] bool given() const { return scene_.numerics.contact_step > 0; }
    /// Marks the limits that do not bind, and adds the step itself.
    [[nodiscard]] std::vector<StepLimit> added_to(std::vector<StepLimit> limits) const;

    /// Throws InputError if contacts of spheres this fast [m/s] gain energy with it: fewer than StepsPerContact::least
    /// steps in an impact.
    void check(double speed) const;
    /// The same in words, for spheres that have become so fast on the way.
    [[nodiscard]] std::optional<Warning> too_long_at(double speed) const;
    /// It is longer than the step of numerics.steps_per_contact, with what that costs.
    [[nodiscard]] std::optional<Warning> inaccurate_at(double speed) const;

  private:
    /// The one that rules, with this many steps in an impact; none: nothing is known yet to touch.
    [[nodiscard]] std::optional<StepLimit> limit_at(double speed, double steps) const;

    const Scene& scene_;
    const SphereSetup& setup_;
};

}  // namespace dmp::solver
