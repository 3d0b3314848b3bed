// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/implicit_system.hpp"

namespace dmp::solver {

std::vector<Vec> SpringBody::on_unknowns(std::span<const Vec> on_particles) const {
    std::vector<Vec> on_unknowns(on_particles.begin(), on_particles.end());
    for (std::size_t n = 0; n < on_unknowns.size(); ++n)
        if (fixed(n)) on_unknowns[n].setZero();
    return on_unknowns;
}

template <int D>
std::vector<Vec> SpringNetwork<D>::balance(std::span<const Vec> w, double dt) const {
    Vectors middle = position_, velocity(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        velocity[n] = of_space(w[n]);
        if (!fixed_[n]) middle[n] += (dt / 2) * velocity[n];
    }
    const Vectors force = forces(middle, velocity);
    std::vector<Vec> sum;
    sum.reserve(ids_.size());
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        Point left = 0.5 * (force[n] - drag_[n] * velocity[n]) - (mass_[n] / dt) * (velocity[n] - velocity_[n]);
        for (int axis = 0; axis < D; ++axis)
            if (is_held(n, axis)) left[axis] = 0;
        sum.push_back(in_space(left));
    }
    return sum;
}

template <int D>
void SpringNetwork<D>::prepare_in_fluid(std::span<const Vec> w, std::span<const Vec> drag, double dt) {
    if (!in_fluid_) in_fluid_ = std::make_unique<ImplicitSystem>(*this);
    Vectors middle = position_;
    std::vector<Vec> drag_in_step(drag.begin(), drag.end());
    for (std::size_t n = 0; n < ids_.size(); ++n) {
        if (!fixed_[n]) middle[n] += (dt / 2) * of_space(w[n]);
        drag_in_step[n] *= dt;
    }
    in_fluid_->factorise(*this, middle, dt, drag_in_step);
    prepared_ = in_fluid_.get();
    prepared_step_ = dt;
}

template <int D>
void SpringNetwork<D>::prepare_alone(std::span<const Vec> w, double dt, bool anew) {
    if (!system_) system_ = std::make_unique<ImplicitSystem>(*this);
    if (anew || !system_->fits(dt)) {
        Vectors middle = position_;
        for (std::size_t n = 0; n < ids_.size(); ++n)
            if (!fixed_[n]) middle[n] += (dt / 2) * of_space(w[n]);
        system_->factorise(*this, middle, dt);
    }
    prepared_ = system_.get();
    prepared_step_ = dt;
}

template <int D>
void SpringNetwork<D>::multiply_in_fluid(std::span<Vec> values) const {
    prepared_->multiply(values, 1 / prepared_step_);
}

template <int D>
void SpringNetwork<D>::solve_in_fluid(std::span<Vec> values) const {
    prepared_->solve(values, prepared_step_);
}

template <int D>
void SpringNetwork<D>::add_prepared(int first, std::vector<Eigen::Triplet<double>>& entries) const {
    prepared_->add_factorised(first, 1 / prepared_step_, entries);
}

template <int D>
void SpringNetwork<D>::expect(std::span<const Vec> w) {
    expected_.clear();
    for (const Vec& velocity : w) expected_.push_back(of_space(velocity));
}

template class SpringNetwork<2>;
template class SpringNetwork<3>;

}  // namespace dmp::solver
