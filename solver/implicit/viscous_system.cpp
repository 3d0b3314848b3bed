// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/implicit/viscous_system.hpp"

#include <algorithm>
#include <cmath>

#include "solver/store/sums_over.hpp"

namespace dmp::solver {

namespace {

/// Arrays of a vector field, by axis.
using Axes = std::array<double*, 3>;

Axes axes_of(ParticleGroup& group, Field field) {
    Axes axes{};
    for (int axis = 0; axis < group.dimension(); ++axis) axes[axis] = group.data(field, axis);
    return axes;
}

}  // namespace

ViscousSystem::ViscousSystem(const Around& around, double dt, const std::array<double, 3>& g)
    : on_(around),
      fluid_(around.particles.fluid()),
      nodes_(around.springs, around.contact, around.particles, dt),
      dt_(dt),
      g_(g) {
    on_.sweep({}, [this](ClusterChoice clusters) { on_.sweeps.viscous_diagonal(on_.particles, on_.list, clusters); });
    nodes_.prepare(on_.particles);

    const Axes diagonal = axes_of(fluid_, Field::viscous_diagonal);
    const double* mass = fluid_.data(Field::mass);
    double worst = 0;  // diagonal over inertia
    for (std::size_t i = 0; i < fluid_.owned(); ++i)
        for (int axis = 0; axis < fluid_.dimension(); ++axis)
            worst = std::max(worst, diagonal[axis][i] * dt_ / mass[i]);
    const ParticleGroup& walls = on_.particles.of(PartKind::rigid);
    std::array<double, 3> largest_of_all{
        std::max(largest(fluid_, Field::viscous_diagonal),
                 largest(on_.particles.of(PartKind::elastic), Field::viscous_diagonal)),
        largest(walls, Field::velocity), worst};
    on_.ranks.largest(largest_of_all);
    largest_diagonal_ = largest_of_all[0];
    fastest_wall_ = largest_of_all[1];
    condition_ = 1 + 2 * largest_of_all[2];

    const Axes v = axes_of(fluid_, Field::velocity), force = axes_of(fluid_, Field::force),
               u = axes_of(fluid_, Field::viscous_velocity);
    auto sums = sums_over<2>(fluid_, on_.threads, [&](std::ptrdiff_t i, auto& sum) {
        double square = 0;
        for (int axis = 0; axis < fluid_.dimension(); ++axis) {
            const double before = v[axis][i] + dt_ * (force[axis][i] / mass[i] + g_[axis]);
            square += before * before;
            u[axis][i] = v[axis][i];
        }
        sum[0].add(mass[i]);
        sum[1].add(mass[i] * square);
    });
    on_.ranks.sum(sums);
    mass_ = sums[0].value();
    velocity_scale_ = std::max(std::sqrt(sums[1].value()), std::sqrt(mass_) * fastest_wall_);
}

double ViscousSystem::largest(const ParticleGroup& group, Field field) const {
    double largest = 0;
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double* values = group.data(field, axis);
        for (std::size_t i = 0; i < group.owned(); ++i) {
            const double size = std::abs(values[i]);
            largest = size <= largest ? largest : size;  // NaN too
        }
    }
    return largest;
}

void ViscousSystem::sweep_forces(Field velocity, double of_walls, double fastest) {
    // No sum is larger than the diagonal times twice the fastest, and no term is.
    const ViscousMotion motion{velocity, of_walls, at_least_something(largest_diagonal_ * fastest / 16)};
    on_.sweep({velocity},
              [&](ClusterChoice clusters) { on_.sweeps.viscous_forces(on_.particles, on_.list, motion, clusters); });
}

double ViscousSystem::true_error() {
    nodes_.show_velocity(on_.particles);
    const double fastest = on_.ranks.largest(std::max(largest(fluid_, Field::viscous_velocity), nodes_.fastest()));
    sweep_forces(Field::viscous_velocity, 1, std::max(fastest, fastest_wall_));
    nodes_.find_residual(on_.particles);

    const double* mass = fluid_.data(Field::mass);
    const Axes v = axes_of(fluid_, Field::velocity), force = axes_of(fluid_, Field::force),
               u = axes_of(fluid_, Field::viscous_velocity), viscous = axes_of(fluid_, Field::viscous_force),
               residual = axes_of(fluid_, Field::viscous_residual);
    auto sums = sums_over<2>(fluid_, on_.threads, [&](std::ptrdiff_t i, auto& sum) {
        double error = 0, square = 0;
        for (int axis = 0; axis < fluid_.dimension(); ++axis) {
            const double r =
                mass[i] / dt_ * (v[axis][i] - u[axis][i]) + mass[i] * g_[axis] + force[axis][i] + viscous[axis][i];
            residual[axis][i] = r;
            error += r * r;
            square += u[axis][i] * u[axis][i];
        }
        sum[0].add(dt_ * dt_ / mass[i] * error);
        sum[1].add(mass[i] * square);
    });
    on_.ranks.sum(sums);
    nodes_.add_errors(sums[0]);
    nodes_.add_squares(sums[1]);
    velocity_scale_ = std::max(velocity_scale_, std::sqrt(sums[1].value()));
    return std::sqrt(sums[0].value());
}

Residual ViscousSystem::start() {
    turn(0);
    return residual_sums();
}

double ViscousSystem::curvature() {
    sweep_forces(Field::viscous_direction, 0, fastest_direction_);
    nodes_.find_image(on_.particles);
    const double* mass = fluid_.data(Field::mass);
    const Axes p = axes_of(fluid_, Field::viscous_direction), viscous = axes_of(fluid_, Field::viscous_force);
    auto [sum] = sums_over<1>(fluid_, on_.threads, [&](std::ptrdiff_t i, auto& own) {
        double product = 0;
        for (int axis = 0; axis < fluid_.dimension(); ++axis)
            product += p[axis][i] * (mass[i] / dt_ * p[axis][i] - viscous[axis][i]);
        own[0].add(product);
    });
    on_.ranks.sum(sum);
    nodes_.add_curvature(sum);
    return sum.value();
}

Residual ViscousSystem::step(double alpha) {
    const double* mass = fluid_.data(Field::mass);
    const Axes p = axes_of(fluid_, Field::viscous_direction), viscous = axes_of(fluid_, Field::viscous_force),
               u = axes_of(fluid_, Field::viscous_velocity), residual = axes_of(fluid_, Field::viscous_residual);
    const auto count = static_cast<std::ptrdiff_t>(fluid_.owned());
    for (int axis = 0; axis < fluid_.dimension(); ++axis) {
#pragma omp parallel for num_threads(on_.threads) schedule(static)
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            u[axis][i] += alpha * p[axis][i];
            residual[axis][i] -= alpha * (mass[i] / dt_ * p[axis][i] - viscous[axis][i]);
        }
    }
    nodes_.step(alpha);
    return residual_sums();
}

Residual ViscousSystem::residual_sums() const {
    const double* mass = fluid_.data(Field::mass);
    const Axes residual = axes_of(fluid_, Field::viscous_residual), diagonal = axes_of(fluid_, Field::viscous_diagonal);
    auto sums = sums_over<2>(fluid_, on_.threads, [&](std::ptrdiff_t i, auto& sum) {
        double weighted = 0, square = 0;
        for (int axis = 0; axis < fluid_.dimension(); ++axis) {
            const double r = residual[axis][i];
            weighted += r * r / (mass[i] / dt_ + diagonal[axis][i]);
            square += r * r;
        }
        sum[0].add(weighted);
        sum[1].add(dt_ * dt_ / mass[i] * square);
    });
    on_.ranks.sum(sums);
    nodes_.add_residual(sums[0]);
    nodes_.add_errors(sums[1]);
    return {sums[0].value(), std::sqrt(sums[1].value())};
}

void ViscousSystem::turn(double beta) {
    const double* mass = fluid_.data(Field::mass);
    const Axes p = axes_of(fluid_, Field::viscous_direction), residual = axes_of(fluid_, Field::viscous_residual),
               diagonal = axes_of(fluid_, Field::viscous_diagonal);
    const auto count = static_cast<std::ptrdiff_t>(fluid_.owned());
    double fastest = 0;
    for (int axis = 0; axis < fluid_.dimension(); ++axis) {
#pragma omp parallel for num_threads(on_.threads) schedule(static) reduction(max : fastest)
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            const double preconditioned = residual[axis][i] / (mass[i] / dt_ + diagonal[axis][i]);
            p[axis][i] = beta == 0 ? preconditioned : preconditioned + beta * p[axis][i];
            fastest = std::max(fastest, std::abs(p[axis][i]));
        }
    }
    nodes_.turn(beta);
    nodes_.show_direction(on_.particles);
    fastest_direction_ = on_.ranks.largest(std::max(fastest, nodes_.fastest_direction()));
}

void ViscousSystem::add_forces() {
    nodes_.hand_over();
    for (ParticleGroup& group : on_.particles.groups()) {
        const Axes force = axes_of(group, Field::force), viscous = axes_of(group, Field::viscous_force);
        const auto count = static_cast<std::ptrdiff_t>(group.owned());
        for (int axis = 0; axis < group.dimension(); ++axis) {
#pragma omp parallel for num_threads(on_.threads) schedule(static)
            for (std::ptrdiff_t i = 0; i < count; ++i) force[axis][i] += viscous[axis][i];
        }
    }
}

}  // namespace dmp::solver
