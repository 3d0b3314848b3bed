// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <cmath>

#include "base/errors.hpp"
#include "solver/time/implicit_system.hpp"

namespace dmp {

SpringBody::SpringBody(SpringBody&&) noexcept = default;
SpringBody& SpringBody::operator=(SpringBody&&) noexcept = default;
SpringBody::~SpringBody() = default;

namespace {

/// Newton ends when no node moves further than this [spacings].
constexpr double tolerance = 1e-9;
constexpr int patience = 8;  ///< iterations with an old matrix before a new one is made
constexpr int most_iterations = 60;

}  // namespace

SpringBody::Impulses SpringBody::advance_implicit(double dt) {
    if (!system_) system_ = std::make_unique<ImplicitSystem>(*this);
    position_before_ = position_;
    const Vectors& before = position_before_;
    const std::size_t nodes = ids_.size();

    // Unknown: the middle x_m = x + dt/2 v_m, with v_m = v + dt/(2 m) F(x_m, v_m). Start from free flight.
    Vectors middle = before, middle_velocity = velocity_;
    for (std::size_t n = 0; n < nodes; ++n)
        if (!fixed_[n]) middle[n] += (dt / 2) * velocity_[n];

    if (!system_->made_for(dt)) system_->factorise(middle, dt);
    bool fresh = false;
    for (int iteration = 1;; ++iteration) {
        std::fill(force_.begin(), force_.end(), Vector<double, 2>{});
        add_forces(middle, middle_velocity, force_);
        Vectors residual(nodes, Vector<double, 2>{});
        for (std::size_t n = 0; n < nodes; ++n)
            if (!fixed_[n])
                residual[n] = (dt / 2) * (force_[n] - drag_ * middle_velocity[n]) -
                              mass_[n] * (middle_velocity[n] - velocity_[n]);
        const double largest = system_->correct(residual, middle, middle_velocity);
        if (largest < tolerance * spacing_) break;
        if (!std::isfinite(largest) || iteration >= most_iterations)
            throw DivergenceError(
                "a spring body near (" + std::to_string(before[0][0]) + ", " + std::to_string(before[0][1]) +
                    ") m is loaded so hard that its next position cannot be found",
                "the fluid around it is likely diverging: lower accuracy.step_factor or check the drive");
        if (iteration % patience == 0 && !fresh) {
            system_->factorise(middle, dt);
            fresh = iteration > 2 * patience;
        }
    }

    Impulses impulses{};
    std::fill(force_.begin(), force_.end(), Vector<double, 2>{});
    add_forces(middle, middle_velocity, force_);
    const Vectors velocity_before = velocity_;
    kick(dt, force_, middle_velocity, impulses);
    for (std::size_t n = 0; n < nodes; ++n)
        if (!fixed_[n]) position_[n] = before[n] + (dt / 2) * (velocity_before[n] + velocity_[n]);
    return impulses;
}

}  // namespace dmp
