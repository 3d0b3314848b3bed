// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/implicit/viscous_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

template <class Visit>
void ViscousNodes::for_each_body(const Visit& visit) const {
    std::size_t unknown = 0, particle = 0;
    for (const auto& body : springs_.bodies()) {
        visit(*body, Part{unknown, body->unknowns()}, Part{particle, body->nodes()});
        unknown += body->unknowns();
        particle += body->nodes();
    }
}

ViscousNodes::ViscousNodes(SpringBodies& springs, SurfaceContact* contact, const ParticleStore& particles, double dt)
    : springs_(springs), contact_(contact), dt_(dt) {
    if (springs_.empty()) return;
    other_force_ = on_unknowns(particles, Field::force);
    const Vectors of_particles = springs_.collected(particles, Field::velocity);
    for_each_body([&](const SpringBody& body, Part, Part own) {
        std::ranges::copy(body.unknown_velocities(own.of(of_particles)), std::back_inserter(velocity_));
    });
    residual_ = preconditioned_ = direction_ = image_ = Vectors(velocity_.size(), Vec::Zero());
}

ViscousNodes::Vectors ViscousNodes::on_unknowns(const ParticleStore& particles, Field field) const {
    const Vectors on_particles = springs_.collected(particles, field);
    Vectors all;
    for_each_body([&](const SpringBody& body, Part, Part own) {
        std::ranges::copy(body.on_unknowns(own.of(on_particles)), std::back_inserter(all));
    });
    return all;
}

void ViscousNodes::show(ParticleStore& particles, Field field, const Vectors& values) const {
    if (springs_.empty()) return;
    Vectors of_particles;
    for_each_body([&](const SpringBody& body, Part part, Part) {
        std::ranges::copy(body.of_particles(part.of(values)), std::back_inserter(of_particles));
    });
    springs_.show_in(particles, field, of_particles);
}

double ViscousNodes::largest(const Vectors& values) {
    double largest = 0;
    for (const Vec& value : values) largest = std::max(largest, value.cwiseAbs().maxCoeff());
    return largest;
}

void ViscousNodes::prepare(const ParticleStore& particles) {
    if (springs_.empty()) return;
    const Vectors drag = on_unknowns(particles, Field::viscous_diagonal);
    for_each_body(
        [&](SpringBody& body, Part part, Part) { body.prepare_in_fluid(part.of(velocity_), part.of(drag), dt_); });
}

void ViscousNodes::find_residual(const ParticleStore& particles) {
    if (springs_.empty()) return;
    const Vectors viscous = on_unknowns(particles, Field::viscous_force);
    for_each_body([&](const SpringBody& body, Part part, Part) {
        const Vectors own = body.balance(part.of(velocity_), dt_);
        for (std::size_t n = 0; n < own.size(); ++n)
            residual_[part.first + n] = own[n] + other_force_[part.first + n] + viscous[part.first + n];
    });
    if (contact_ != nullptr) {
        contact_->add_forces_at_end(velocity_, residual_);
        if (!held_.is_ready()) held_.factorise(springs_, *contact_);
    }
    precondition();
}

void ViscousNodes::precondition() {
    preconditioned_ = residual_;
    if (held_.is_ready()) held_.solve(preconditioned_);
    for (std::size_t b = 0, first = 0; b < springs_.bodies().size(); ++b) {
        const SpringBody& body = *springs_.bodies()[b];
        const Part part{first, body.unknowns()};
        if (contact_ == nullptr || !contact_->touched_bodies()[b]) body.solve_in_fluid(part.of(preconditioned_));
        first += part.count;
    }
}

void ViscousNodes::find_image(const ParticleStore& particles) {
    if (springs_.empty()) return;
    const Vectors viscous = on_unknowns(particles, Field::viscous_force);
    image_ = direction_;
    for_each_body([&](const SpringBody& body, Part part, Part) { body.multiply_in_fluid(part.of(image_)); });
    for (std::size_t n = 0; n < image_.size(); ++n) image_[n] -= viscous[n];
    if (contact_ != nullptr) contact_->add_stiffness_times(direction_, image_);
}

void ViscousNodes::step(double alpha) {
    for (std::size_t n = 0; n < velocity_.size(); ++n) {
        velocity_[n] += alpha * direction_[n];
        residual_[n] -= alpha * image_[n];
    }
    precondition();
}

void ViscousNodes::turn(double beta) {
    for (std::size_t n = 0; n < direction_.size(); ++n)
        direction_[n] = beta == 0 ? preconditioned_[n] : Vec(preconditioned_[n] + beta * direction_[n]);
}

void ViscousNodes::hand_over() const {
    for_each_body([&](SpringBody& body, Part part, Part) { body.expect(part.of(velocity_)); });
}

void ViscousNodes::add_squares(ExactSum& sum) const {
    for_each_body([&](const SpringBody& body, Part part, Part) {
        for (std::size_t n = 0; n < part.count; ++n)
            sum.add(body.unknown_mass(n) * velocity_[part.first + n].squaredNorm());
    });
}

void ViscousNodes::add_errors(ExactSum& sum) const {
    for_each_body([&](const SpringBody& body, Part part, Part) {
        for (std::size_t n = 0; n < part.count; ++n) {
            const Vec& residual = residual_[part.first + n];
            sum.add(dt_ * dt_ / body.unknown_mass(n) * residual.dot(residual));
        }
    });
}

void ViscousNodes::add_residual(ExactSum& sum) const {
    for (std::size_t n = 0; n < residual_.size(); ++n) sum.add(residual_[n].dot(preconditioned_[n]));
}

void ViscousNodes::add_curvature(ExactSum& sum) const {
    for (std::size_t n = 0; n < direction_.size(); ++n) sum.add(direction_[n].dot(image_[n]));
}

}  // namespace dmp::solver
