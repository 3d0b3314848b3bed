// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/implicit/viscous_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

ViscousNodes::ViscousNodes(SpringBodies& springs, const ParticleStore& particles, double dt)
    : springs_(springs), dt_(dt) {
    if (springs_.empty()) return;
    other_force_ = springs_.collected(particles, Field::force);
    velocity_ = springs_.collected(particles, Field::velocity);
    residual_ = preconditioned_ = direction_ = image_ = Vectors(velocity_.size(), Vec::Zero());
}

template <class Visit>
void ViscousNodes::for_each_body(const Visit& visit) const {
    std::size_t first = 0;
    for (const auto& body : springs_.bodies()) {
        visit(*body, first);
        first += body->nodes();
    }
}

void ViscousNodes::show(ParticleStore& particles, Field field, const Vectors& values) const {
    if (!springs_.empty()) springs_.show_in(particles, field, values);
}

double ViscousNodes::largest(const Vectors& values) {
    double largest = 0;
    for (const Vec& value : values) largest = std::max(largest, value.cwiseAbs().maxCoeff());
    return largest;
}

void ViscousNodes::prepare(const ParticleStore& particles) {
    if (springs_.empty()) return;
    const Vectors drag = springs_.collected(particles, Field::viscous_diagonal);
    for_each_body([&](SpringBody& body, std::size_t first) {
        const std::size_t count = body.nodes();
        body.prepare_in_fluid(std::span(velocity_).subspan(first, count), std::span(drag).subspan(first, count), dt_);
    });
}

void ViscousNodes::find_residual(const ParticleStore& particles) {
    if (springs_.empty()) return;
    const Vectors viscous = springs_.collected(particles, Field::viscous_force);
    for_each_body([&](SpringBody& body, std::size_t first) {
        const Vectors own = body.balance(std::span(velocity_).subspan(first, body.nodes()), dt_);
        for (std::size_t n = 0; n < own.size(); ++n) {
            residual_[first + n].setZero();
            if (!body.fixed(n)) residual_[first + n] = own[n] + other_force_[first + n] + viscous[first + n];
        }
    });
    preconditioned_ = residual_;
    for_each_body([&](SpringBody& body, std::size_t first) {
        body.solve_in_fluid(std::span(preconditioned_).subspan(first, body.nodes()));
    });
}

void ViscousNodes::find_image(const ParticleStore& particles) {
    if (springs_.empty()) return;
    const Vectors viscous = springs_.collected(particles, Field::viscous_force);
    image_ = direction_;
    for_each_body([&](SpringBody& body, std::size_t first) {
        const std::size_t count = body.nodes();
        body.multiply_in_fluid(std::span(image_).subspan(first, count));
        for (std::size_t n = first; n < first + count; ++n)
            if (!body.fixed(n - first)) image_[n] -= viscous[n];
    });
}

void ViscousNodes::step(double alpha) {
    for (std::size_t n = 0; n < velocity_.size(); ++n) {
        velocity_[n] += alpha * direction_[n];
        residual_[n] -= alpha * image_[n];
    }
    preconditioned_ = residual_;
    for_each_body([&](SpringBody& body, std::size_t first) {
        body.solve_in_fluid(std::span(preconditioned_).subspan(first, body.nodes()));
    });
}

void ViscousNodes::turn(double beta) {
    for (std::size_t n = 0; n < direction_.size(); ++n)
        direction_[n] = beta == 0 ? preconditioned_[n] : Vec(preconditioned_[n] + beta * direction_[n]);
}

void ViscousNodes::hand_over() const {
    for_each_body([&](SpringBody& body, std::size_t first) {
        body.expect(std::span(velocity_).subspan(first, body.ids().size()));
    });
}

void ViscousNodes::add_squares(ExactSum& sum) const {
    for_each_body([&](const SpringBody& body, std::size_t first) {
        for (std::size_t n = 0; n < body.ids().size(); ++n) sum.add(body.mass(n) * velocity_[first + n].squaredNorm());
    });
}

void ViscousNodes::add_errors(ExactSum& sum) const {
    for_each_body([&](const SpringBody& body, std::size_t first) {
        for (std::size_t n = 0; n < body.nodes(); ++n)
            sum.add(dt_ * dt_ / body.mass(n) * residual_[first + n].dot(residual_[first + n]));
    });
}

void ViscousNodes::add_residual(ExactSum& sum) const {
    for (std::size_t n = 0; n < residual_.size(); ++n) sum.add(residual_[n].dot(preconditioned_[n]));
}

void ViscousNodes::add_curvature(ExactSum& sum) const {
    for (std::size_t n = 0; n < direction_.size(); ++n) sum.add(direction_[n].dot(image_[n]));
}

}  // namespace dmp::solver
