// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "solver/elastic/implicit_system.hpp"

namespace dmp::solver {

template <int D>
SpringNetwork<D>::SpringNetwork(SpringNetwork&&) noexcept = default;
template <int D>
SpringNetwork<D>& SpringNetwork<D>::operator=(SpringNetwork&&) noexcept = default;
template <int D>
SpringNetwork<D>::~SpringNetwork() = default;

namespace {

/// Newton's method ends when no node moves farther than this [spacings].
constexpr double tolerance = 1e-9;
constexpr int iterations_with_one_matrix = 8;  ///< iterations with an old matrix before it is factorised again
constexpr int most_iterations = 60;
/// A step that cannot be solved is halved at most this often.
constexpr int most_halvings = 6;

}  // namespace

template <int D>
typename SpringNetwork<D>::Impulses SpringNetwork<D>::advance_implicit(double dt) {
    position_before_ = position_;
    Impulses impulses{};
    if (!expected_.empty()) {
        impulses = advance_as_expected(dt);
    } else {
        if (!system_) system_ = std::make_unique<ImplicitSystem>(*this);
        advance_in_parts(dt, most_halvings, impulses);
    }
    pressing_.clear();
    return impulses;
}

template <int D>
void SpringNetwork<D>::press(std::span<const Vec> on_unknowns) {
    pressing_.clear();
    for (std::size_t n = 0; n < ids_.size(); ++n) pressing_.push_back(of_space(on_unknowns[n]));
}

template <int D>
typename SpringNetwork<D>::Vectors SpringNetwork<D>::all_forces(const Vectors& position,
                                                                const Vectors& velocity) const {
    Vectors force = forces(position, velocity);
    for (std::size_t n = 0; n < pressing_.size(); ++n) force[n] += pressing_[n];
    return force;
}

template <int D>
typename SpringNetwork<D>::Impulses SpringNetwork<D>::advance_as_expected(double dt) {
    const Vectors mean = std::exchange(expected_, {});
    Vectors middle = position_;
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) middle[n] += (dt / 2) * mean[n];
    force_ = all_forces(middle, mean);
    Impulses impulses{};
    kick(dt, force_, mean, impulses);
    for (std::size_t n = 0; n < ids_.size(); ++n)
        if (!fixed_[n]) position_[n] += dt * mean[n];
    return impulses;
}

template <int D>
void SpringNetwork<D>::archive(Archive& file, const std::string& name) {
    const std::size_t nodes = ids_.size();
    file(name + "/position", position_);
    file(name + "/velocity", velocity_);
    file(name + "/position_before", position_before_);
    if (position_.size() != nodes || velocity_.size() != nodes || position_before_.size() != nodes)
        throw InputError("the checkpoint's elastic bodies are not those of the scene", "start the run anew");
    if (!system_) system_ = std::make_unique<ImplicitSystem>(*this);
    system_->archive(file, name, *this);
}

template <int D>
void SpringNetwork<D>::advance_in_parts(double dt, int halvings_left, Impulses& impulses) {
    crushed_at_.reset();
    if (solve_step(dt, impulses)) return;
    if (halvings_left == 0) refuse_crushed_cells();
    if (halvings_left == 0)
        throw DivergenceError("the load on an elastic body near (" + std::to_string(position_[0][0]) + ", " +
                                  std::to_string(position_[0][1]) +
                                  ") m is so large that its next position cannot be computed",
                              "the fluid around it is likely diverging: lower numerics.step_factor or check the drive");
    advance_in_parts(dt / 2, halvings_left - 1, impulses);
    advance_in_parts(dt / 2, halvings_left - 1, impulses);
}

template <int D>
bool SpringNetwork<D>::solve_step(double dt, Impulses& impulses) {
    const std::size_t nodes = ids_.size();
    // Unknown: the midpoint x_m = x + dt/2 v_m, with v_m = v + dt/(2 m) F(x_m, v_m). Starts from free flight.
    Vectors middle = position_, middle_velocity = velocity_;
    for (std::size_t n = 0; n < nodes; ++n)
        if (!fixed_[n]) middle[n] += (dt / 2) * velocity_[n];

    if (!system_->fits(dt)) system_->factorise(*this, middle, dt);
    for (int iteration = 1;; ++iteration) {
        force_ = all_forces(middle, middle_velocity);
        Vectors residual(nodes, Point{});
        for (std::size_t n = 0; n < nodes; ++n)
            if (!fixed_[n])
                residual[n] = (dt / 2) * (force_[n] - drag_[n] * middle_velocity[n]) -
                              mass_[n] * (middle_velocity[n] - velocity_[n]);
        const double largest = system_->correct(residual, dt, middle, middle_velocity);
        if (largest < tolerance * spacing_) break;
        if (!(largest < spacing_) || iteration >= most_iterations) return false;  // also false for NaN
        if (iteration % iterations_with_one_matrix == 0) system_->factorise(*this, middle, dt);
    }

    force_ = all_forces(middle, middle_velocity);
    const Vectors velocity_before = velocity_;
    kick(dt, force_, middle_velocity, impulses);
    for (std::size_t n = 0; n < nodes; ++n)
        if (!fixed_[n]) position_[n] += (dt / 2) * (velocity_before[n] + velocity_[n]);
    return true;
}

template class SpringNetwork<2>;
template class SpringNetwork<3>;

}  // namespace dmp::solver
